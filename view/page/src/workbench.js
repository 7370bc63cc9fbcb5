// The middle of the page: 3D view, playback, axis readout and program on one side, plots on the other.
import { css, diverging, sequential } from './colour.js';
import { barTicks } from './pathlines.js';
import { clock, element, fixed, limitNames, short } from './words.js';

const speeds = [0.1, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
const playedInSeconds = 30;

/** `still`: a picture that stands over the view until it is drawn, or null. */
export function workbenchFrame(still) {
  const canvas = element('canvas', { id: 'view', 'aria-label': '3D view of part, path, tool and machine' });
  const frame = {
    canvas, legend: element('div.legend'), viewTools: element('div.toolbar.over'), stage: null,
    playback: element('div.playback'), readout: element('div.readout'), program: element('div.program-host'), plots: element('div.plots'),
  };
  frame.stage = element('div.stage', {}, canvas, still, frame.viewTools, frame.legend);
  frame.node = element('section.workbench', {}, element('div.left', {}, frame.stage, frame.playback, frame.readout, frame.program), frame.plots);
  return frame;
}

function choice(label, options, onchange, attributes = {}) {
  return element('label.choice', {}, `${label} `, element('select', { onchange: (event) => onchange(event.target.value), ...attributes },
    ...options.map(([value, name]) => element('option', { value }, name))));
}

function tick(label, checked, onchange, attributes = {}) {
  return element('label.choice', {}, element('input', { type: 'checkbox', checked, onchange: (event) => onchange(event.target.checked), ...attributes }), ` ${label}`);
}

/** Buttons over the 3D view. Called again when the run is there. */
export function viewTools(frame, scene, run) {
  const bar = frame.viewTools;
  bar.replaceChildren(choice('View', [['part', 'part'], ['top', 'from above'], ['tool', 'tool'], ...(scene.links ? [['machine', 'machine']] : [])], (what) => {
    if (what === 'machine') scene.showMachine('solid');
    scene.look(what);
  }, { id: 'look' }));
  if (scene.links) {
    bar.append(choice('Machine', [['ghost', 'ghost'], ['solid', 'solid'], ['hidden', 'hidden']], (how) => scene.showMachine(how), { id: 'machine-shown' }));
    bar.append(choice('Still', [['part', 'part'], ['machine', 'machine']], (what) => { scene.machineStill = what === 'machine'; if (scene.run) scene.showTime(); }));
  }
  if (!run) return;
  const paths = scene.tip.colourings.map(({ id, name }) => [id, `tool tip by ${name}`]);
  if (scene.planned) paths.push(['plan-turn', 'planned path by turn'], ['plan-tilt', 'planned path by tilt']);
  bar.append(choice('Path', [...paths, ['none', 'hidden']], (id) => colourPath(frame, scene, id), { id: 'path-colour' }));
  if (scene.columns.has('surface.deviation')) bar.append(tick('deviation', false, (on) => showDeviation(frame, scene, on), { id: 'deviation' }));
  bar.append(tick('tool axes', false, (on) => { scene.strokes.visible = on; scene.invalidate(); }, { id: 'tool-axes' }));
  bar.append(tick('follow', false, (on) => { scene.following = on; scene.showTime(); }));
  const slow = (scene.report.report.run?.feed_loss_percent ?? 0) < -2;
  bar.querySelector('#path-colour').value = slow ? 'feed' : 'time';   // an even feed shows nothing
  colourPath(frame, scene, slow ? 'feed' : 'time');
}

function colourPath(frame, scene, id) {
  const planned = id.startsWith('plan-');
  scene.tip.group.visible = !planned && id !== 'none';
  if (scene.planned) scene.planned.line.visible = planned;
  frame.pathLegend = id === 'none' ? null : planned ? scene.planned.colourBy(id.slice(5)) : scene.tip.colourBy(id);
  scene.invalidate();
  legend(frame);
}

function showDeviation(frame, scene, on) {
  const range = scene.colourSurface(on);
  frame.deviationLegend = on ? { bar: ['deviation of the surface, mm', -range, range], colour: (share) => diverging(2 * share - 1) } : null;
  legend(frame);
}

function colourBar({ bar, colour = sequential }) {
  const stops = Array.from({ length: 17 }, (_, i) => css(colour(i / 16))).join(',');
  const ramp = element('div.ramp');
  ramp.style.background = `linear-gradient(to right, ${stops})`;
  return element('div.colour-bar', {}, element('div', {}, bar[0]), ramp, element('div.ticks', {}, ...barTicks(bar).map((text) => element('span', {}, text))));
}

function legend(frame) {
  const parts = [];
  for (const entry of [frame.pathLegend, frame.deviationLegend]) {
    if (entry?.bar) parts.push(colourBar(entry));
    if (entry?.keys) parts.push(element('div.keys', {}, ...entry.keys.map(([name, colour]) => {
      const swatch = element('i');
      swatch.style.background = colour;
      return element('span', {}, swatch, name);
    })));
  }
  frame.legend.replaceChildren(...parts);
}

/** Play, speed, place in time. */
export function playback(frame, run) {
  const usual = speeds.reduce((best, speed) => (Math.abs(Math.log(speed * playedInSeconds / run.end)) < Math.abs(Math.log(best * playedInSeconds / run.end)) ? speed : best), 1);
  let speed = usual, playing = false, last = 0;
  const button = element('button.play', { id: 'play', 'aria-label': 'play or pause' }, '▶ Play');
  const slider = element('input', { type: 'range', min: 0, max: run.end, step: 'any', value: 0, id: 'time', 'aria-label': 'time of the run' });
  const now = element('span.clock', { id: 'clock' });
  const step = (instant) => {
    if (!playing) return;
    run.setTime(run.time + speed * (instant - last) / 1000);
    last = instant;
    if (run.time >= run.end) stop();
    else requestAnimationFrame(step);
  };
  const stop = () => { playing = false; button.textContent = '▶ Play'; };
  button.addEventListener('click', () => {
    if (playing) { stop(); return; }
    if (run.time >= run.end) run.setTime(0);
    playing = true;
    button.textContent = '❚❚ Pause';
    last = performance.now();
    requestAnimationFrame(step);
  });
  slider.addEventListener('input', () => run.setTime(Number(slider.value)));
  const rate = element('select', { id: 'speed', 'aria-label': 'playback speed', onchange: (event) => { speed = Number(event.target.value); } },
    ...speeds.map((value) => element('option', { value, selected: value === usual }, `${value} ×`)));
  frame.playback.replaceChildren(button, slider, now, rate);
  run.onTime((time) => {
    slider.value = time;
    now.textContent = `${clock(time)} / ${clock(run.end)}`;
  });
}

/** Position, speed and share of the limit of every axis at this moment, the feed, the line, and what holds the speed down. */
export function readout(frame, run, axes, onLine) {
  const cells = axes.map((axis) => ({ axis, position: element('td'), speed: element('td'), share: element('div.fill') }));
  const table = element('table', {}, ...cells.map(({ axis, position, speed, share }) =>
    element('tr', {}, element('th', {}, axis.letter), position, speed, element('td', {}, element('div.bar', { title: 'speed, share of its limit' }, share)))));
  const said = element('div.moment', { id: 'moment' });
  frame.readout.replaceChildren(table, said);
  const lines = run.trace.integers('line'), limits = run.trace.integers('limit'), holders = run.trace.integers('limiting_axis');
  run.onTime((time) => {
    const place = run.place(time);
    for (const { axis, position, speed, share } of cells) {
      const unit = axis.rotary ? 'deg' : 'mm', velocity = run.value(`velocity.${axis.letter}`, place);
      position.textContent = `${fixed(run.value(`position.${axis.letter}`, place), 3)} ${unit}`;
      speed.textContent = `${fixed(velocity, 2)} ${unit}/s`;
      share.style.width = `${Math.min(100 * Math.abs(velocity) / axis.velocity_max, 100)}%`;
    }
    const holder = holders[place.index] >= 0 && axes.length ? ` of ${axes[holders[place.index]].letter}` : '';
    said.replaceChildren(element('div', {}, 'Line ', element('b', {}, String(lines[place.index]))),
      element('div', {}, 'Feed ', element('b', {}, `${short(run.value('feed', place))} mm/min`)),
      element('div', {}, 'Held by ', element('b', {}, limitNames[limits[place.index]] + holder)));
    said.dataset.line = lines[place.index];
    said.dataset.time = time;
    onLine(lines[place.index]);
  });
}
