// The page of a run: numbers first, then the part, then what the axes did.
import 'uplot/dist/uPlot.min.css';
import './report.css';
import { Columns, jsonPart, packedPart } from './data.js';
import { findingsSection, hardestSection, slowestSection, warningsSection } from './findings.js';
import { cards, deviations, everyNumber, introduction, rotaryPlan, tableOfPaper, whereTimeGoes } from './numbers.js';
import { AxisPlots } from './plots.js';
import { ProgramText } from './program.js';
import { Run } from './run.js';
import { Scene3d } from './scene.js';
import { element } from './words.js';
import { playback, readout, viewTools, workbenchFrame } from './workbench.js';

// A frame, or a quarter of a second where none comes (a browser that draws nothing, a page behind others): what follows must not wait for it.
const nextFrame = () => new Promise((resolve) => { requestAnimationFrame(() => setTimeout(resolve, 0)); setTimeout(resolve, 250); });
const ready = (stage) => { document.documentElement.dataset.ready = stage; performance.mark(`volute-${stage}`); };

/** The live view, or null without WebGL: then the still stays in its place, and all the rest works. */
function makeScene(frame, report, columns, still) {
  try {
    return new Scene3d(frame.canvas, report, columns);
  } catch (error) {
    const note = element('p.note', { id: 'no-webgl' }, `This browser shows no 3D (${error.message}): the part stands still here, the rest works.`);
    frame.stage.replaceChildren(...[still, note].filter(Boolean));
    return null;
  }
}

async function start() {
  const report = jsonPart('report');
  const page = document.getElementById('page');
  const still = document.getElementById('still');   // the part as the run drew it, in sight until the live view stands
  const frame = workbenchFrame(still);
  const after = element('div');
  page.replaceChildren(...[introduction(report), cards(report), frame.node, after].filter(Boolean));
  const state = { run: null, plots: null };
  const show = ({ time, line }) => {
    if (!state.run) return;
    const known = time > 0 || !(line > 0) ? time : state.run.timeOfLine(line);
    state.run.setTime(known ?? 0);
    state.plots.reveal(state.run.time);
    frame.node.scrollIntoView({ block: 'start', behavior: 'smooth' });
  };
  after.replaceChildren(...[findingsSection(report, show), warningsSection(report, show), tableOfPaper(report), whereTimeGoes(report), rotaryPlan(report), deviations(report), slowestSection(report, show), everyNumber(report)].filter(Boolean));

  if (still) {
    await still.decode().catch(() => {});   // a still that cannot be shown is no reason to show nothing
    await nextFrame();
    ready('picture');
  }
  const columns = new Columns(await packedPart('scene'));
  const scene = makeScene(frame, report, columns, still);
  if (scene) viewTools(frame, scene, null);
  await nextFrame();
  if (scene) {
    scene.finish();
    still?.remove();
  }
  ready('scene');

  const traceBytes = await packedPart('trace');
  if (traceBytes) await addRun(frame, report, scene, new Columns(traceBytes), state, after, show);
  ready('all');
}

async function addRun(frame, report, scene, trace, state, after, show) {
  const run = new Run(trace);
  const axes = report.machine?.axes ?? [];
  state.run = run;
  const program = await packedPart('program');
  const text = program ? new ProgramText(frame.program, program, (line) => {
    const time = run.timeOfLine(line);
    if (time !== null) { run.setTime(time); state.plots.reveal(time); }
  }) : null;
  playback(frame, run);
  readout(frame, run, axes, (line) => text?.setLine(line));
  if (scene) {
    scene.setRun(run);
    viewTools(frame, scene, run);
    run.onTime(() => scene.showTime());
    frame.canvas.addEventListener('click', (event) => {
      const sample = scene.sampleNear(event.clientX, event.clientY);
      if (sample !== null) { run.setSample(sample); state.plots.reveal(run.time); }
    });
  }
  run.setTime(0);
  await nextFrame();
  frame.plots.append(element('p.note', {}, 'Click a peak to see the tool there. Drag to zoom, wheel to zoom in and out. Red dashes: limits of the machine.'));
  state.plots = new AxisPlots(frame.plots, run, report);
  const hardest = hardestSection(run, axes, show);
  if (hardest) after.insertBefore(hardest, after.children[1] ?? null);
}

start().catch((error) => {
  document.getElementById('page').prepend(element('p.rejected', {}, `This page could not be shown: ${error.message}`));
  throw error;
});
