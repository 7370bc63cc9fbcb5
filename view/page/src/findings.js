// Lists of moments: what the verifier found, where each axis works hardest, the slowest blocks. A click shows the moment.
import { element, kindWords, limitNames, short, timeText } from './words.js';

const rowsMax = 400;

function momentTable(id, heads, rows, show) {
  return element('div.scroll.tall', {}, element('table.moments', { id }, element('tr', {}, ...heads.map((head) => element('th', {}, head))),
    ...rows.map(({ cells, moment }) => {
      const go = () => show(moment);
      return element('tr', { tabindex: 0, role: 'button', onclick: go, onkeydown: (event) => { if (event.key === 'Enter') go(); } },
        ...cells.map((value) => element('td', {}, value)));
    })));
}

export function findingsSection({ findings }, show) {
  const section = element('section', { id: 'findings' }, element('h2', {}, 'What was found'));
  if (!findings.length) {
    section.append(element('p', {}, 'Nothing: no collision, no gouge, no uncut material, no axis past a limit.'));
    return section;
  }
  const kinds = new Map();
  for (const { kind } of findings) kinds.set(kind, (kinds.get(kind) ?? 0) + 1);
  const host = element('div');
  const fill = (kind) => {
    const chosen = kind ? findings.filter((finding) => finding.kind === kind) : findings;
    host.replaceChildren(momentTable('findings-table', ['line', 'time', 'kind', 'what'], chosen.slice(0, rowsMax).map((finding) => ({
      cells: [finding.line > 0 ? String(finding.line) : '–', timeText(finding.time_s), finding.kind, finding.text], moment: { line: finding.line, time: finding.time_s },
    })), show));
    if (chosen.length > rowsMax) host.append(element('p.note', {}, `The first ${rowsMax} of ${chosen.length}; all stand in report.json.`));
  };
  const chip = (kind, label, title) => element('button.chip', { title, onclick: () => fill(kind) }, label);
  section.append(element('p.note', {}, 'Click a row to see the moment in the view above, with its line of the program.'),
    element('div.toolbar', {}, chip('', `all (${findings.length})`, 'everything'), ...[...kinds].map(([kind, count]) => chip(kind, `${kind} (${count})`, kindWords[kind]))), host);
  fill('');
  return section;
}

/** What does not reject the program, but should be known. */
export function warningsSection({ report }, show) {
  const warnings = report.warnings ?? [];
  if (!warnings.length) return null;
  const section = element('section', { id: 'warnings' }, element('h2', {}, 'Warnings'),
    element('p.note', {}, 'These do not reject the program. Click a row to see the moment.'),
    momentTable('warnings-table', ['line', 'time', 'kind', 'what'], warnings.slice(0, rowsMax).map((warning) => ({
      cells: [warning.block > 0 ? String(warning.block) : '–', warning.time_s > 0 ? timeText(warning.time_s) : '–', warning.kind, warning.text],
      moment: { line: warning.block, time: warning.time_s },
    })), show));
  if (warnings.length > rowsMax) section.append(element('p.note', {}, `The first ${rowsMax} of ${warnings.length}; all stand in report.json.`));
  return section;
}

/** For each axis and quantity the sample that comes closest to the limit while cutting (or at all, when nothing cuts). */
export function hardestMoments(run, axes) {
  const rows = [], motion = run.trace.integers('motion');
  const wanted = motion.includes(1) ? 1 : motion[0];
  for (const axis of axes)
    for (const [quantity, limit] of [['velocity', axis.velocity_max], ['acceleration', axis.acceleration_max], ['jerk', axis.jerk_max]]) {
      if (!(limit > 0)) continue;
      const values = run.trace.values(`${quantity}.${axis.letter}`);
      let most = motion.indexOf(wanted);
      for (let i = most; i < values.length; ++i) if (motion[i] === wanted && Math.abs(values[i]) > Math.abs(values[most])) most = i;
      rows.push({ axis, quantity, sample: most, value: values[most], share: Math.abs(values[most]) / limit });
    }
  return rows.sort((a, b) => b.share - a.share);
}

export function hardestSection(run, axes, show) {
  if (!axes.length) return null;
  const lines = run.trace.integers('line'), limits = run.trace.integers('limit');
  const rows = hardestMoments(run, axes).slice(0, 9).map(({ axis, quantity, sample, value, share }) => ({
    cells: [`${axis.letter} ${quantity}`, `${short(value)} ${axis.rotary ? 'deg' : 'mm'}${{ velocity: '/s', acceleration: '/s²', jerk: '/s³' }[quantity]}`,
      `${Math.round(100 * share)} %`, timeText(run.times[sample]), String(lines[sample]), limitNames[limits[sample]]],
    moment: { time: run.times[sample] },
  }));
  return element('section', {}, element('h2', {}, 'Where each axis works hardest'),
    element('p.note', {}, 'The greatest speed, acceleration and jerk of every axis while cutting, against what the machine allows. Click a row to go there.'),
    momentTable('hardest', ['axis', 'peak', 'of its limit', 'time', 'line', 'held by'], rows, show));
}

export function slowestSection({ report }, show) {
  const blocks = report.run?.worst_blocks ?? [];
  if (!blocks.length) return null;
  return element('section', {}, element('h2', {}, 'Which lines cost the most time'),
    element('p.note', {}, 'Blocks that ran slower than their programmed feed, by seconds lost.'),
    momentTable('slowest', ['line', 'lost', 'programmed', 'actual'], blocks.map((block) => ({
      cells: [String(block.block), timeText(block.lost_s), `${short(block.programmed_feed_mm_min)} mm/min`, `${short(block.actual_feed_mm_min)} mm/min`],
      moment: { line: block.block, time: block.time_s },
    })), show));
}
