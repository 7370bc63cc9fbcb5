// The machine of the run: where its links and the tool stand for given axis positions. Formulas of kinematics/model/chain.cpp.
import * as THREE from 'three';

const radians = Math.PI / 180;

export class Machine {
  constructor(description) {
    this.axes = description.axes.map((axis) => ({ ...axis, direction: new THREE.Vector3(...axis.direction), point: new THREE.Vector3(...axis.point) }));
    this.chain = description.chain;
    this.tableAxes = description.table_axes;
    this.links = description.links;
    this.partInMachine = new THREE.Matrix4().fromArray(description.part_in_machine);
    this.gauge = new THREE.Matrix4().fromArray(description.gauge);
  }

  motion(axis, position) {
    const displacement = position - axis.zero;
    if (!axis.rotary) return new THREE.Matrix4().makeTranslation(axis.direction.clone().multiplyScalar(displacement));
    const turn = new THREE.Matrix4().makeRotationAxis(axis.direction, displacement * radians);
    const moved = axis.point.clone().applyMatrix4(turn);
    return turn.setPosition(axis.point.clone().sub(moved));
  }

  /** Products of the first 0, 1, ... axes of the chain; positions in mm and degrees, in the order of the axes. */
  products(positions) {
    const products = [new THREE.Matrix4()];
    for (const index of this.chain) products.push(products.at(-1).clone().multiply(this.motion(this.axes[index], positions[index])));
    return products;
  }

  /** Where a link stands in the workpiece table's frame; -1 is the base. */
  linkMotion(link, products) {
    if (link === -1) return products[this.tableAxes];
    const place = this.chain.indexOf(link);
    return products[place < this.tableAxes ? place : place + 1];
  }

  /** The tool's frame (z from tip to holder, origin at the tip). */
  toolFrame(products, gaugeLength) {
    return products.at(-1).clone().multiply(this.gauge).multiply(new THREE.Matrix4().makeTranslation(0, 0, -gaugeLength));
  }
}
