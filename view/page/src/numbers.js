// What stands above the pictures: the run in a sentence, its figures, Table 2, where the time goes, and every number.
import { causeNames, element, fixed, pick, short, tableTwo, timeText } from './words.js';

export function introduction({ report, planned, program, machine }) {
  const what = planned
    ? 'Volute planned a five-axis finishing path for this part and wrote it as the program '
    : 'This page shows the program ';
  const how = planned ? '. Then it read that text back and ran it ' : ', read from its text and run ';
  const where = machine ? `on a virtual ${machine.name} (${machine.title}), cycle by cycle: what you see is what the axes would do.` : 'cycle by cycle.';
  const blocks = report.program?.blocks ? ` (${report.program.blocks.toLocaleString('en-US')} blocks)` : '';
  return element('p.intro', {}, what, element('code', {}, program || 'without a name'), blocks, how, where);
}

function card(name, value, unit, note, state = '') {
  return element(`div.card${state}`, {}, element('div.card-name', {}, name),
    element('div.card-value', {}, value, unit ? element('span.unit', {}, ` ${unit}`) : null), element('div.card-note', {}, note));
}

export function cards({ report }) {
  const list = element('div.cards');
  const { run, machining, collision } = report;
  if (run) {
    list.append(card('Cycle time', timeText(run.cycle_time_s), '', 'from the first block to the last'));
    list.append(card('Actual feed', short(run.actual_feed_mm_min), 'mm/min',
      `of ${short(run.programmed_feed_mm_min)} programmed: ${fixed(run.feed_loss_percent, 2)} %`, run.feed_loss_percent < -5 ? '.watch' : ''));
  }
  if (machining) {
    list.append(card('Ridge left (scallop)', fixed(machining.scallop_max_mm, 3), 'mm', `99 % of the surface is below ${fixed(machining.scallop_p99_mm, 3)} mm`));
    list.append(card('Deepest gouge', fixed(machining.gouge_max_mm, 3), 'mm', 'how far the cutter went below the design surface'));
    list.append(card('Uncut material', machining.uncut ? `${short(machining.uncut_area_mm2)}` : 'none', machining.uncut ? 'mm²' : '',
      'area left higher than the allowed ridge', machining.uncut ? '.bad' : ''));
  }
  if (report.stock) {
    const { stock } = report;
    list.append(card('Material removed', short(stock.removed_mm3 / 1000), 'cm³',
      `of a blank of ${short(stock.first_mm3 / 1000)} cm³${stock.assumed ? ', assumed: the job names none' : ''}`));
    if (stock.removal_rate_max_mm3_s !== undefined)
      list.append(card('Fastest removal', short(stock.removal_rate_max_mm3_s * 0.06), 'cm³/min', `at line ${stock.removal_rate_at_block}`));
  }
  if (collision) {
    const hits = collision.sim_hits > 0;
    list.append(card('Collisions', String(collision.sim_hits), '', `${short(collision.pairs_checked)} pairs of bodies checked`, hits ? '.bad' : ''));
    if (collision.closest_pair)
      list.append(card('Closest approach', short(collision.closest_mm, 3), 'mm', `${collision.closest_pair}${collision.at_block ? `, line ${collision.at_block}` : ''}`));
  }
  return list;
}

function cell(value, key = '') {
  if (key.endsWith('_percent') && typeof value === 'number') return fixed(value, 2);
  if (value === undefined || value === null) return '–';
  if (typeof value === 'boolean') return value ? 'yes' : 'no';
  return typeof value === 'number' ? (Number.isInteger(value) ? String(value) : short(value)) : String(value);
}

export function tableOfPaper({ report }) {
  const columns = tableTwo.filter(([key]) => pick(report, key) !== undefined);
  if (columns.length < 3) return null;
  return element('section', {}, element('h2', {}, 'How the path compares'),
    element('p.note', {}, 'The columns of Table 2 in the paper that this work follows (Sun et al., 2016). Fewer interruptions and corners mean a steadier machine.'),
    element('div.scroll', {}, element('table', { id: 'table-2' },
      element('tr', {}, ...columns.map(([, name, meaning]) => element('th', { title: meaning }, name))),
      element('tr', {}, ...columns.map(([key]) => element('td', {}, cell(pick(report, key), key)))),
      element('tr.meaning', {}, ...columns.map(([, , meaning]) => element('td', {}, meaning))))));
}

/** Horizontal bars: name, seconds, share of the whole. */
function bars(rows, whole, colour) {
  return element('div.bars', {}, ...rows.filter(([, seconds]) => seconds > 0).map(([name, seconds]) => {
    const bar = element('div.bar', {}, element('div.fill'));
    bar.firstChild.style.cssText = `width:${Math.max((100 * seconds) / whole, 0.3)}%;background:${colour}`;
    return element('div.bar-row', {}, element('div.bar-name', {}, name), bar, element('div.bar-value', {}, `${timeText(seconds)}, ${fixed((100 * seconds) / whole, 1)} %`));
  }));
}

export function whereTimeGoes({ report }) {
  const causes = Object.entries(report.run?.time_by_cause ?? {});
  if (!causes.length) return null;
  const whole = causes.reduce((sum, [, seconds]) => sum + seconds, 0) || 1;
  const rows = causes.map(([cause, seconds]) => [causeNames[cause] ?? cause.replaceAll('_', ' '), seconds]).sort((a, b) => b[1] - a[1]);
  const limiting = Object.entries(report.run.limiting ?? {}).filter(([, seconds]) => seconds > 0).map(([axis, seconds]) => [`held up by axis ${axis}`, seconds]);
  return element('section', {}, element('h2', {}, 'Where the time goes'), bars(rows, whole, '#0072b2'),
    limiting.length ? element('p.note', {}, 'And which axis held the tool below its programmed feed:') : null, bars(limiting, whole, '#d55e00'));
}

/** Both rotary axes as they were planned, at the programmed feed, before the control. */
export function rotaryPlan({ report }) {
  const plan = report.orientation;
  const letters = Object.keys(plan ?? {}).filter((key) => plan[key]?.velocity_max !== undefined);
  if (!letters.length) return null;
  const heads = ['axis', 'greatest speed, rad/s', 'greatest acceleration, rad/s²', 'greatest jerk, rad/s³'];
  const smoothings = { none: 'not smoothed: the tool swings only where it must', velocity: 'smoothed for least angular velocity', acceleration: 'smoothed for least angular acceleration',
    field: 'along an orientation field', corridor: 'smoothed within what is allowed' };
  return element('section', {}, element('h2', {}, 'How the tool turns'),
    element('p.note', {}, `Orientation as planned at the programmed feed, before the control: ${smoothings[plan.smoothing] ?? plan.smoothing}. `
      + `${plan.interferences_before ?? 0} points of the path touched something before, ${plan.interferences_after ?? 0} after.`),
    element('div.scroll', {}, element('table', { id: 'rotary-plan' }, element('tr', {}, ...heads.map((head) => element('th', {}, head))),
      ...letters.map((letter) => element('tr', {}, ...[letter, plan[letter].velocity_max, plan[letter].acceleration_max, plan[letter].jerk_max].map((value) => element('td', {}, cell(value))))))));
}

/** Deviations of the machined surface as bars of an SVG. */
export function deviations({ histogram, report }) {
  if (!histogram) return null;
  const { counts, least_mm: least, step_mm: step } = histogram;
  let first = counts.findIndex((count) => count > 0), last = counts.length - 1;
  if (first < 0) return null;
  while (counts[last] === 0) --last;
  [first, last] = [Math.max(first - 1, 0), Math.min(last + 1, counts.length - 1)];
  const most = Math.max(...counts.slice(first, last + 1)), total = counts.reduce((sum, count) => sum + count, 0);
  const width = 900, height = 190, left = 10, base = 150, span = last - first + 1;
  const x = (bin) => left + ((bin - first) / span) * (width - 2 * left);
  let body = '';
  for (let bin = first; bin <= last; ++bin) {
    const tall = counts[bin] > 0 ? Math.max((counts[bin] / most) * (base - 12), 1) : 0;
    const at = least + (bin + 0.5) * step;
    body += `<rect x="${x(bin).toFixed(2)}" y="${(base - tall).toFixed(2)}" width="${Math.max((width - 2 * left) / span - 0.4, 0.4).toFixed(2)}" height="${tall.toFixed(2)}" fill="${at < 0 ? '#2b5fa8' : '#b5602a'}"><title>${fixed(at, 4)} mm: ${fixed((100 * counts[bin]) / total, 2)} %</title></rect>`;
  }
  const ticks = niceTicks(least + first * step, least + (last + 1) * step, 8);
  for (const tick of ticks) {
    const at = left + ((tick - least - first * step) / (span * step)) * (width - 2 * left);
    body += `<path d="M${at.toFixed(1)} ${base}v6" stroke="#444"/><text x="${at.toFixed(1)}" y="${base + 20}" text-anchor="middle">${short(tick, 3)}</text>`;
  }
  const figure = element('div.histogram');
  figure.innerHTML = `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="histogram of deviations" font-size="12" fill="#333"><path d="M${left} ${base}H${width - left}" stroke="#444"/>${body}<text x="${width / 2}" y="${height - 4}" text-anchor="middle">deviation from the design surface, mm</text></svg>`;
  return element('section', {}, element('h2', {}, 'How true the surface is'),
    element('p.note', {}, `${total.toLocaleString('en-US')} places of the surface were measured after the virtual cut. Brown: material left above the design surface. Blue: cut below it.`
      + (report.machining?.uncut_area_mm2 ? ` ${short(report.machining.uncut_area_mm2)} mm² stand higher than allowed.` : '')), figure);
}

export function niceTicks(least, greatest, wanted) {
  const rough = (greatest - least) / wanted, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((candidate) => candidate >= rough);
  const ticks = [];
  for (let k = Math.ceil(least / step - 1e-9); k * step <= greatest * (1 + 1e-12) + 1e-12; ++k) ticks.push(k * step);
  return ticks;
}

function rowsOf(object, prefix) {
  return Object.entries(object).flatMap(([key, value]) => {
    if (value !== null && typeof value === 'object' && !Array.isArray(value)) return rowsOf(value, `${prefix}${key}.`);
    if (Array.isArray(value) && value.some((item) => typeof item === 'object')) return [];
    return [[prefix + key, Array.isArray(value) ? value.join('; ') : cell(value)]];
  });
}

export function everyNumber({ report }) {
  return element('details', {}, element('summary', {}, 'Every number of the run'),
    element('p.note', {}, 'Lengths in mm, angles in degrees, times in seconds. The same as report.json beside this page, rounded.'),
    element('table.numbers', {}, ...rowsOf(report, '').map(([name, value]) => element('tr', {}, element('td', {}, name), element('td', {}, value)))));
}
