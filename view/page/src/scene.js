// The 3D view: part, obstacles, machine, tool and path, drawn only when something changes.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Machine } from './machine.js';
import { axisStrokes, PlannedPath, TipPath } from './pathlines.js';
import { deviationColours, solid, toolBody } from './solids.js';

const partColour = '#a9b8c6', obstacleColour = '#b08968', linkColour = '#7d8ea3';
const pickPixels = 12;
const standardView = new THREE.Vector3(-0.45, -1, 0.8);

export class Scene3d {
  constructor(canvas, report, columns) {
    this.canvas = canvas;
    this.report = report;
    this.columns = columns;
    const context = canvas.getContext('webgl2', { antialias: true, powerPreference: 'high-performance' });
    if (!context) throw new Error('no WebGL 2');
    this.renderer = new THREE.WebGLRenderer({ canvas, context });
    this.renderer.debug.checkShaderErrors = false;   // asking for a program's errors waits for the compiler
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color('#fbfcfd');
    this.camera = new THREE.PerspectiveCamera(32, 1, 1, 1e5);
    this.camera.up.set(0, 0, 1);
    this.world = new THREE.Group();   // everything stands in the table's frame M; world takes M to what stands still
    this.world.matrixAutoUpdate = false;
    this.part = new THREE.Group();    // what stands in the part's frame P
    this.part.matrixAutoUpdate = false;
    this.world.add(this.part);
    this.scene.add(this.world, this.camera);
    this.addLights();
    this.addSolids();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.invalidate());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.look('part');
    this.resize();
  }

  addLights() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a929b, 1.5));
    const key = new THREE.DirectionalLight(0xffffff, 1.7);
    key.position.set(-0.6, 0.9, 1);
    this.camera.add(key);
  }

  addSolids() {
    const { report, columns } = this;
    if (columns.count('surface.corners') > 0) {
      this.surface = solid(columns, 'surface', partColour);
      this.part.add(this.surface);
    }
    this.obstacles = new THREE.Group();
    report.obstacles.forEach((_, i) => this.obstacles.add(solid(columns, `obstacle${i}`, obstacleColour, { flat: true })));
    this.part.add(this.obstacles);
    this.tool = toolBody(report.tool);
    this.tool.matrixAutoUpdate = false;
    this.tool.visible = false;
    this.world.add(this.tool);
    if (report.machine) this.addMachine();
    this.box = new THREE.Box3();
    if (this.surface) this.box.expandByObject(this.surface);
    if (report.obstacles.length) this.box.expandByObject(this.obstacles);
  }

  addMachine() {
    this.machine = new Machine(this.report.machine);
    this.links = new THREE.Group();
    this.machine.links.forEach((link, i) => {
      const mesh = solid(this.columns, `link${i}`, linkColour, { flat: true });
      mesh.matrixAutoUpdate = false;
      mesh.userData.link = link.link;
      this.links.add(mesh);
    });
    this.links.visible = false;   // the part first: another kind of material costs a compilation
    this.world.add(this.links);
    this.part.matrix.copy(this.machine.partInMachine);
    this.world.matrix.copy(this.machine.partInMachine).invert();
  }

  /** The run, once the trace is there. */
  setRun(run) {
    this.run = run;
    this.size = this.sizeOf(run);
    this.tip = new TipPath(run, this.report.machine, this.size);
    this.strokes = axisStrokes(run, Math.max(0.06 * this.size, this.report.tool.radius_mm));
    this.strokes.visible = false;
    this.part.add(this.tip.group, this.strokes);
    if (this.columns.has('plan.turn')) {
      this.planned = new PlannedPath(this.columns);
      this.part.add(this.planned.line);
    }
    this.tool.visible = true;
    this.showMachine('ghost');
    if (!this.looked) this.look('part');
  }

  /** Extent of the part, or of the cutting path when there is no part. */
  sizeOf(run) {
    if (this.box.isEmpty()) {
      const tips = run.trace.points('tip'), motion = run.trace.integers('motion');
      for (let i = 0; i < run.count; ++i) if (motion[i] === 1) this.box.expandByPoint(new THREE.Vector3().fromArray(tips, 3 * i));
      if (this.box.isEmpty()) this.box.set(new THREE.Vector3(-50, -50, -50), new THREE.Vector3(50, 50, 50));
    }
    return this.box.getSize(new THREE.Vector3()).length();
  }

  showMachine(how) {
    if (!this.links) return;
    this.links.visible = how !== 'hidden';
    for (const mesh of this.links.children) {
      const ghost = how === 'ghost';
      Object.assign(mesh.material, { transparent: ghost, opacity: ghost ? 0.1 : 1, depthWrite: !ghost });
      mesh.material.needsUpdate = true;
    }
    this.invalidate();
  }

  colourSurface(byDeviation) {
    const { geometry, material } = this.surface;
    let range = null;
    if (byDeviation) {
      const { colours, range: found } = deviationColours(this.columns);
      geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
      range = found;
    }
    material.vertexColors = byDeviation;
    material.color.set(byDeviation ? '#ffffff' : partColour);
    material.needsUpdate = true;
    this.invalidate();
    return range;
  }

  /** Moves tool and links to where they stand at the run's time. */
  showTime() {
    const { run, machine } = this;
    const place = run.place(run.time);
    if (machine) {
      const products = machine.products(machine.axes.map((axis) => run.value(`position.${axis.letter}`, place)));
      this.tool.matrix.copy(machine.toolFrame(products, this.report.tool.gauge_length_mm));
      for (const mesh of this.links.children) mesh.matrix.copy(machine.linkMotion(mesh.userData.link, products));
      const still = this.machineStill ? machine.linkMotion(-1, products) : machine.partInMachine;
      this.world.matrix.copy(still).invert();
    } else {
      this.tool.matrix.copy(this.traceFrame(place));
    }
    this.tip.showUpTo(place.index);
    if (this.following) this.follow();
    this.invalidate();
  }

  traceFrame({ index }) {
    const tip = new THREE.Vector3().fromArray(this.run.trace.points('tip'), 3 * index);
    const axis = new THREE.Vector3().fromArray(this.run.trace.points('axis'), 3 * index).normalize();
    return new THREE.Matrix4().makeRotationFromQuaternion(new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), axis)).setPosition(tip);
  }

  tipInScene() {
    this.world.updateMatrixWorld(true);
    return new THREE.Vector3().setFromMatrixPosition(this.tool.matrix).applyMatrix4(this.world.matrix);
  }

  follow() {
    const shift = this.tipInScene().sub(this.controls.target);
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.camera.lookAt(this.controls.target);
  }

  /** Takes the camera to 'part', 'top', 'tool' or 'machine'. */
  look(what) {
    const box = what === 'machine' && this.links ? this.machineBox() : this.box;
    if (box.isEmpty()) return;
    this.looked = true;
    const centre = box.getCenter(new THREE.Vector3()), size = box.getSize(new THREE.Vector3());
    let radius = 0.5 * size.length();
    if (what === 'tool' && this.run) {
      centre.copy(this.tipInScene());
      radius = Math.max(6 * this.report.tool.radius_mm, 0.1 * radius);
    }
    const direction = what === 'top' ? new THREE.Vector3(0, -0.001, 1) : standardView.clone();
    const half = Math.min(this.camera.fov * Math.PI / 360, Math.atan(Math.tan(this.camera.fov * Math.PI / 360) * this.camera.aspect));
    const distance = (0.92 * radius) / Math.sin(half);
    this.camera.position.copy(centre).addScaledVector(direction.normalize(), distance);
    this.camera.near = distance / 200;
    this.camera.far = distance * 60;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(centre);
    this.controls.update();
    this.invalidate();
  }

  machineBox() {
    this.world.updateMatrixWorld(true);
    return new THREE.Box3().expandByObject(this.links).union(this.box);
  }

  /** The sample of the path point nearest to a place on the canvas, or null. */
  sampleNear(x, y) {
    const rect = this.canvas.getBoundingClientRect();
    const matrix = new THREE.Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse).multiply(this.world.matrix).multiply(this.part.matrix);
    const point = new THREE.Vector4();
    let best = null, bestCost = Infinity;
    this.tip.samples.forEach((sample, k) => {
      point.set(this.tip.positions[3 * k], this.tip.positions[3 * k + 1], this.tip.positions[3 * k + 2], 1).applyMatrix4(matrix);
      const dx = (0.5 + 0.5 * point.x / point.w) * rect.width - (x - rect.left), dy = (0.5 - 0.5 * point.y / point.w) * rect.height - (y - rect.top);
      const away = Math.hypot(dx, dy);
      if (point.w <= 0 || away > pickPixels) return;
      const cost = away + (100 * point.w) / this.size;   // among near ones the one in front
      if (cost < bestCost) [best, bestCost] = [sample, cost];
    });
    return best;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0 || (width === this.width && height === this.height)) return;
    Object.assign(this, { width, height });
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  invalidate() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.draw());
  }

  /** Returns when the graphics process has drawn what was asked for: the picture is there, not only on its way. */
  finish() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  draw() {
    this.waiting = false;
    this.renderer.render(this.scene, this.camera);
  }
}
