// The page of a diagnosis: verdict, missing force over time and in the drift–yaw plane, ranking, replays, what to sail next.

let EFFECTS = {};  // words of every effect, by its id: the document tells them

const QUANTITIES = { heading: 'Heading', yaw_rate: 'Yaw rate', speed: 'Speed', drift: 'Drift angle', position: 'Position' };

const AXES = [
  { id: 'surge_force', name: 'Surge force X', short: 'X', key: 'X_N', deviation: 'X_deviation_N', unit: 'N' },
  { id: 'sway_force', name: 'Sway force Y', short: 'Y', key: 'Y_N', deviation: 'Y_deviation_N', unit: 'N' },
  { id: 'yaw_moment', name: 'Yaw moment N', short: 'N', key: 'N_Nm', deviation: 'N_deviation_Nm', unit: 'N\u202fm' },
];

const BEFORE = { id: 'missing_before', label: 'Refitted model, without effects', color: '#0072b2', band: 'rgba(0, 114, 178, 0.17)' };
const AFTER = { id: 'missing_after', label: '', color: '#e07b00', band: 'rgba(224, 123, 0, 0.2)' };
const ORDINARY_FILL = '#f0f2f4';
const PLACE_FILL = 'rgba(150, 120, 200, 0.22)';
const ONSET_COLOR = '#8a2be2';

const REPLAYS = [
  { id: 'recorded', label: 'Recorded', line: { color: '#2b2b2b', width: 2.1 } },
  { id: 'given', label: 'Model as given', line: { color: '#8b949e', width: 1.5, dash: '2px,3px' } },
  { id: 'refitted', label: 'Refitted, without effects', line: { color: '#0072b2', width: 1.7, dash: '6px,3px' } },
  { id: 'after', label: '', line: { color: '#e07b00', width: 1.9 } },
];

const UNITS = [
  ['_rad_s', 'deg/s', DEGREES], ['_m_s', 'm/s', 1], ['_rad', 'deg', DEGREES], ['_N', 'N', 1], ['_m', 'm', 1], ['_s', 's', 1],
];

const GREEK = { tau: 'τ', kappa: 'κ', gamma: 'γ', zeta: 'ζ', delta: 'δ', phi: 'φ' };

// The model with effects is called by what the verdict makes of them.
function nameAfter(verdict) {
  AFTER.label = verdict === 'unexplained' ? 'With the effects that come nearest' : 'With the effects found';
  REPLAYS.find(({ id }) => id === 'after').label = AFTER.label;
}

// ---- words and numbers -------------------------------------------------------------------

const capital = (words) => words.charAt(0).toUpperCase() + words.slice(1);
const nameOf = (id) => EFFECTS[id] || id.replaceAll('_', ' ');
const namesOf = (ids) => ids.map(nameOf).join(', ');

// Names of effects as in ship files, put into plain words.
const inWords = (text) => text.replace(/[a-z]+(?:_[a-z]+)+|\bgust\b(?! of)/g, (id) => EFFECTS[id] || id);

function certainty(probability) {
  if (!isNumber(probability)) return MISSING;
  if (probability > 0.9995) return '> 0.999';
  return probability < 0.0005 ? '< 0.001' : probability.toFixed(3);
}

// A value to the second digit of its standard error.
function decimalsOf(error) {
  return isNumber(error) && error > 0 ? Math.min(Math.max(1 - Math.floor(Math.log10(error)), 0), 8) : 3;
}

function fixed(value, decimals) {
  if (!isNumber(value)) return MISSING;
  const text = value.toFixed(decimals);
  return plain(Number(text) === 0 ? text.replace('-', '') : text);
}

// Two digits below a per cent, where errors of good models are.
function share(fraction) {
  if (!isNumber(fraction) || Math.abs(fraction) >= 0.00995) return percent(fraction);
  return `${plain(Number((100 * fraction).toPrecision(2)))}\u00a0%`;
}

// "wind_speed_m_s" is a wind speed in m/s; the rate of a clock is a share.
function measured(key) {
  if (key === 'rate') return { stem: key, unit: '%', scale: 100 };
  const [ending, unit, scale] = UNITS.find(([end]) => key.endsWith(end) && !/^[A-Za-z]{1,2}$/.test(key.slice(0, -end.length))) ||
    UNITS.find(([end]) => key.endsWith(end) && GREEK[key.slice(0, -end.length)]) || ['', '', 1];
  return { stem: key.slice(0, key.length - ending.length), unit, scale };
}

// The same with a prefix for a large force.
function measuredAs(key, value) {
  const found = measured(key);
  return found.unit === 'N' && isNumber(value) ? { ...found, ...prefixed('N', Math.abs(value)) } : found;
}

function symbol(stem) {
  const [head, ...rest] = stem.split('_');
  const letter = GREEK[head] || (head.length <= 2 ? head : null);
  if (!letter) return [capital(stem.replaceAll('_', ' '))];
  return rest.length > 0 ? [el('i', {}, letter), el('sub', {}, rest.join(' '))] : [el('i', {}, letter)];
}

const POINTS = ['N', 'NNE', 'NE', 'ENE', 'E', 'ESE', 'SE', 'SSE', 'S', 'SSW', 'SW', 'WSW', 'W', 'WNW', 'NW', 'NNW'];
const compassPoint = (degrees) => POINTS[Math.round((((degrees % 360) + 360) % 360) / 22.5) % 16];

// Force or moment with a prefix that keeps its largest value readable.
function prefixed(unit, largest) {
  const [prefix, scale] = largest >= 2e6 ? ['M', 1e-6] : largest >= 2e3 ? ['k', 1e-3] : ['', 1];
  return { unit: `${prefix}${unit}`, scale };
}

function quantile(values, share) {
  const sorted = values.filter(isNumber).sort((a, b) => a - b);
  return sorted.length > 0 ? sorted[Math.min(Math.floor(share * sorted.length), sorted.length - 1)] : 0;
}

const median = (values) => quantile(values, 0.5);

// ---- effects found -----------------------------------------------------------------------

// Its number and what it is called; a clock runs slow or fast by some share, as in words.
function toldAs(key, value) {
  const found = measuredAs(key, value);
  if (key !== 'rate') return found;
  return value < 0 ? { ...found, stem: 'fast', scale: -found.scale } : { ...found, stem: 'slow' };
}

function parameterRow(key, { value, standard_error: error }) {
  const { stem, unit, scale } = toldAs(key, value);
  const scaledError = error * Math.abs(scale), decimals = decimalsOf(scaledError);
  const point = /_(from|to)$/.test(stem) ? ` ${compassPoint(value * scale)}` : '';
  return row(
    el('th', { scope: 'row' }, ...symbol(stem)),
    el('td', {}, fixed(value * scale, decimals)),
    el('td', { class: 'error' }, isNumber(error) ? `± ${fixed(scaledError, decimals)}` : ''),
    el('td', { class: 'unit' }, `${unit}${point}`));
}

function rivalsNote(rivals) {
  if (!rivals || rivals.length === 0) return null;
  return el('p', { class: 'note' }, `These runs are explained as well by: ${namesOf(rivals)}.`);
}

function effectCard(effect) {
  const keys = effect.keys || Object.keys(effect.parameters);
  return el('div', { class: 'card' },
    el('h3', {}, capital(effect.label || nameOf(effect.effect)), ' ', small(effect.effect)),
    el('p', { class: 'facts' }, `Probability ${certainty(effect.probability)}`),
    el('table', { class: 'parameters' }, el('tbody', {}, ...keys.map((key) => parameterRow(key, effect.parameters[key])))),
    rivalsNote(effect.indistinguishable_from));
}

// ---- where force is missing --------------------------------------------------------------

const isLacking = (run) => Boolean(run.series.missing_before);
const forcesOf = (run) => [BEFORE, AFTER].filter(({ id }) => run.series[id]);

// One scale for all runs, so that panels side by side can be compared.
function rangeOf(report, axisOf) {
  const tops = report.runs.flatMap((run) => forcesOf(run).map(({ id }) => {
    const { [axisOf.key]: mean, [axisOf.deviation]: deviation } = run.series[id];
    return quantile(mean.map((value, i) => Math.abs(value) + 2 * deviation[i]), 0.995);
  }));
  const ordinary = report.ordinary_force ? report.ordinary_force[axisOf.key] : 0;
  return 1.08 * Math.max(0, 2.6 * ordinary, ...tops) || 1;
}

function forceScales(report) {
  return AXES.map((axisOf) => {
    const range = rangeOf(report, axisOf);
    return { ...axisOf, range, ordinary: report.ordinary_force ? report.ordinary_force[axisOf.key] : null, ...prefixed(axisOf.unit, range) };
  });
}

// Mean with the band of two standard deviations.
function forceTraces(run, source, scaleOf, index) {
  const { [scaleOf.key]: mean, [scaleOf.deviation]: deviation } = run.series[source.id];
  const time = run.series.time_s;
  const edge = (sign) => mean.map((value, i) => (value + sign * 2 * deviation[i]) * scaleOf.scale);
  const shared = { type: 'scatter', mode: 'lines', yaxis: `y${index + 1}`, meta: source.id };
  return [
    { ...shared, x: [...time, ...[...time].reverse()], y: [...edge(1), ...edge(-1).reverse()], fill: 'toself', fillcolor: source.band, line: { width: 0 }, hoverinfo: 'skip' },
    { ...shared, x: time, y: mean.map((value) => value * scaleOf.scale), name: source.label, line: { color: source.color, width: 1.7 },
      hovertemplate: `%{y:.3~g} ${scaleOf.unit}` },
  ];
}

function ordinaryShade(scaleOf, index) {
  if (!isNumber(scaleOf.ordinary)) return null;
  const edge = 2 * scaleOf.ordinary * scaleOf.scale;
  return { type: 'rect', layer: 'below', xref: 'x domain', yref: `y${index + 1}`, x0: 0, x1: 1, y0: -edge, y1: edge, fillcolor: ORDINARY_FILL, line: { width: 0 } };
}

// A place that is no force shades all panels.
function placeShades(run, report) {
  return report.location.filter((place) => place.run === run.run && isNumber(place.from_s)).flatMap((place) => {
    const panels = AXES.some(({ id }) => id === place.quantity) ? AXES.map(({ id }, i) => (id === place.quantity ? i : -1)) : AXES.map((_, i) => i);
    return panels.filter((i) => i >= 0).map((i) => ({
      type: 'rect', layer: 'below', xref: 'x', yref: `y${i + 1} domain`, x0: place.from_s, x1: place.to_s, y0: 0, y1: 1, fillcolor: PLACE_FILL, line: { width: 0 },
    }));
  });
}

// Times at which effects begin and end, in this run.
function turnsOf(run, report) {
  const last = run.series.time_s.at(-1);
  return report.effects.flatMap((effect) => [['begins', effect.onset_s], ['ends', effect.end_s]]
    .filter(([, time]) => isNumber(time) && time > run.series.time_s[0] && time < last)
    .map(([deed, time]) => ({ time, deed, words: `${effect.effect.replaceAll('_', ' ')} ${deed}` })));
}

function turnLines(turns) {
  return turns.map(({ time }) => ({
    type: 'line', xref: 'x', yref: 'paper', x0: time, x1: time, y0: 0, y1: 1, line: { color: ONSET_COLOR, width: 1.3, dash: 'dash' },
  }));
}

// Words outside of the two lines, unless the edge of the plot is near; at the bottom, where little is drawn.
function turnLabels(turns, run) {
  const [first, last] = [run.series.time_s[0], run.series.time_s.at(-1)];
  const left = ({ time, deed }) => (deed === 'begins' ? time > first + 0.3 * (last - first) : time > last - 0.2 * (last - first));
  return turns.map((turn, i) => ({
    xref: 'x', yref: 'paper', x: turn.time, y: 0, yshift: 2 + 14 * i, yanchor: 'bottom', xanchor: left(turn) ? 'right' : 'left', showarrow: false,
    text: turn.words, font: { size: 11, color: ONSET_COLOR },
  }));
}

function drawForces(run, report, scales, node) {
  const turns = turnsOf(run, report);
  const axes = panelAxes(scales.map(({ short, unit }) => ({ title: `${short}, ${unit}` })));
  scales.forEach(({ range, scale }, i) => { axes[`yaxis${i + 1}`].range = [-range * scale, range * scale]; });
  plot(node, scales.flatMap((scaleOf, i) => forcesOf(run).flatMap((source) => forceTraces(run, source, scaleOf, i))), {
    margin: MARGIN,
    hovermode: 'x unified',
    xaxis: axis('Time, s', { anchor: `y${scales.length}`, hoverformat: '.1f', nticks: 7, range: [run.series.time_s[0], run.series.time_s.at(-1)] }),
    ...axes,
    shapes: [...scales.map(ordinaryShade), ...placeShades(run, report), ...turnLines(turns)].filter(Boolean),
    annotations: turnLabels(turns, run),
  });
}

function placeWords(place) {
  const axisOf = AXES.find(({ id }) => id === place.quantity);
  const name = axisOf ? axisOf.name : (QUANTITIES[place.quantity] || place.quantity);
  const where = place.where ? `, ${inWords(place.where)}` : '';
  const part = isNumber(place.share) ? `, ${percent(place.share)} of what is missing in the run` : '';
  return `${name} from ${between(place.from_s, place.to_s)}${part}${where}.`;
}

function runTitle(run) {
  return el('h3', { class: 'run-title' }, run.run.replace(/\.csv$/, ''), ' ', small([run.manoeuvre, run.held_out ? 'held out' : null].filter(Boolean).join(' · ')));
}

function forceCell(run, report, scales) {
  const places = report.location.filter((place) => place.run === run.run);
  return el('div', {}, runTitle(run),
    plotBox('forces', `Missing force in ${run.run}`, (node) => drawForces(run, report, scales, node), run.run),
    ...places.map((place) => el('p', { class: 'note' }, placeWords(place))));
}

function swatch(style, words) {
  return el('label', {}, el('span', { class: 'swatch', style }), words);
}

const filled = (color) => `height: 1rem; border: 0; background: ${color}`;

function forceKey(report) {
  const withEffects = report.runs.some((run) => run.series.missing_after);
  return el('div', { class: 'key' },
    swatch(`border-color: ${BEFORE.color}`, BEFORE.label),
    withEffects ? swatch(`border-color: ${AFTER.color}`, AFTER.label) : null,
    swatch(filled(ORDINARY_FILL), 'What an adequate model leaves out'),
    report.location.length > 0 ? swatch(filled(PLACE_FILL), 'Where most is missing') : null,
    report.effects.some(({ onset_s: onset }) => isNumber(onset)) ? swatch(`border-color: ${ONSET_COLOR}; border-top-style: dashed`, 'Effect begins or ends') : null);
}

function grid(cells) {
  return el('div', { class: `runs runs-${Math.min(cells.length, 3)}` }, ...cells);
}

function forceSection(report) {
  const runs = report.runs.filter(isLacking);
  if (runs.length === 0) return null;
  const scales = forceScales(report);
  return el('section', { class: 'part', id: 'where' }, el('h2', {}, 'Missing force over time'),
    el('p', { class: 'note' }, 'Force and moment on the ship and the water she entrains (mass with added mass times the acceleration that the model leaves out), ' +
      'estimated from the whole run: mean and two standard deviations. X forward, Y to starboard, N about midship with the bow to starboard. All runs have the same scales.'),
    forceKey(report), grid(runs.map((run) => forceCell(run, report, scales))));
}

// ---- drift–yaw plane ---------------------------------------------------------------------

const SIGNED = [[0, '#2166ac'], [0.25, '#7fb2d8'], [0.5, '#e3e6e9'], [0.75, '#ee9c7f'], [1, '#b2182b']];

function planeReach(report) {
  const all = (get) => quantile(report.runs.filter(isLacking).flatMap((run) => get(run.series.motion).map(Math.abs)), 0.998);
  return { drift: 1.1 * DEGREES * all(({ drift_rad: drift }) => drift), yaw: 1.1 * all(({ r_prime: yaw }) => yaw) };
}

function drawPlane(run, { scaleOf, source, reach, top }, node) {
  const { drift_rad: drift, r_prime: yaw } = run.series.motion;
  const force = run.series[source.id][scaleOf.key];
  const order = force.map((_, i) => i).sort((a, b) => Math.abs(force[a]) - Math.abs(force[b]));  // the largest on top
  plot(node, [{
    type: 'scatter', mode: 'markers', x: order.map((i) => drift[i] * DEGREES), y: order.map((i) => yaw[i]),
    customdata: order.map((i) => run.series.time_s[i]), text: order.map((i) => `${digits(force[i] * scaleOf.scale)} ${scaleOf.unit}<br>at ${seconds(run.series.time_s[i])} s`),
    marker: { size: 5.5, color: order.map((i) => force[i]), colorscale: SIGNED, cmin: -top, cmax: top, showscale: false },
    hovertemplate: 'drift %{x:.3~g} deg, r′ %{y:.3~g}<br>%{text}<extra></extra>',
  }], {
    margin: MARGIN,
    hovermode: 'closest',
    xaxis: axis('Drift angle β, deg', { range: [-reach.drift, reach.drift] }),
    yaxis: axis('Yaw rate r′ = r L / U', { range: [-reach.yaw, reach.yaw] }),
  });
}

function chooser(label, options, chosen, onChange) {
  const select = el('select', { 'aria-label': label }, ...options.map(({ id, name }) => el('option', { value: id }, name)));
  select.value = chosen;
  select.addEventListener('change', () => onChange(select.value));
  return select;
}

// The axis that the diagnosis names most often; without one, that on which most is missing, over what is ordinary.
function mainAxis(report, scales) {
  const named = scales.map(({ id }) => report.location.filter(({ quantity }) => quantity === id).length);
  if (Math.max(...named) > 1) return scales[named.indexOf(Math.max(...named))];
  const size = ({ key, ordinary }) => report.runs.filter((run) => isLacking(run) && !run.held_out)
    .reduce((sum, run) => sum + quantile(run.series.missing_before[key].map(Math.abs), 0.9), 0) / (ordinary || 1);
  return scales.reduce((best, scaleOf) => (size(scaleOf) > size(best) ? scaleOf : best), scales[0]);
}

function colorBar(top, scaleOf) {
  const colors = SIGNED.map(([place, color]) => `${color} ${100 * place}%`).join(', ');
  const edge = digits(top * scaleOf.scale);
  return [el('span', {}, `−${edge}`), el('span', { class: 'ramp', style: `background: linear-gradient(to right, ${colors})` }), el('span', {}, `+${edge} ${scaleOf.unit}`)];
}

function planeSection(report) {
  const runs = report.runs.filter(isLacking);
  if (runs.length === 0) return null;
  const scales = forceScales(report);
  const reach = planeReach(report);
  const sources = [BEFORE, AFTER].filter(({ id }) => runs.every((run) => run.series[id]));
  const shown = { axisId: mainAxis(report, scales).id, sourceId: BEFORE.id };
  const bar = el('span', { class: 'colorbar' });
  const view = () => {
    const scaleOf = scales.find(({ id }) => id === shown.axisId);
    const large = quantile(runs.flatMap((run) => run.series.missing_before[scaleOf.key].map(Math.abs)), 0.98);
    const top = Math.max(large, 2 * (scaleOf.ordinary || 0)) || 1;
    return { scaleOf, reach, top, source: sources.find(({ id }) => id === shown.sourceId) };
  };
  const boxes = runs.map((run) => plotBox('plane', `Drift angle and yaw rate in ${run.run}`, (node) => drawPlane(run, view(), node), run.run));
  const paintBar = () => bar.replaceChildren(...colorBar(view().top, view().scaleOf));
  const redraw = () => {
    paintBar();
    boxes.forEach((box, i) => pending.has(box) || drawPlane(runs[i], view(), box));
  };
  paintBar();
  const axisChoice = chooser('Force', scales, shown.axisId, (id) => { shown.axisId = id; redraw(); });
  const sourceChoice = chooser('Model', sources.map(({ id, label }) => ({ id, name: label.toLowerCase() })), shown.sourceId, (id) => { shown.sourceId = id; redraw(); });
  return el('section', { class: 'part', id: 'plane' }, el('h2', {}, 'Missing force by motion'),
    el('div', { class: 'key' }, el('label', {}, 'Missing', axisChoice), sources.length > 1 ? el('label', {}, 'of the model', sourceChoice) : null, bar),
    grid(runs.map((run, i) => el('div', {}, runTitle(run), boxes[i]))),
    el('p', { class: 'note' }, 'Each point is a moment of the run, at the drift angle and yaw rate estimated for it; its colour is the force or moment missing there. ' +
      'Opposite colours on the two sides: odd in the motion, as of hull or rudder. The same colour on both: one side always, as of an offset. A colour that changes along a circle: wind, waves, current.'));
}

// ---- ranking -----------------------------------------------------------------------------

function remarkOf(candidate, report) {
  if (report.effects.some(({ effect }) => effect === candidate.effect)) return report.verdict === 'unexplained' ? 'comes nearest' : 'found';
  const rivalOf = report.effects.find(({ indistinguishable_from: rivals }) => (rivals || []).includes(candidate.effect));
  if (rivalOf) return `explains the runs as well as ${nameOf(rivalOf.effect)}`;
  if (candidate.refuted) return 'runs that were not used speak against it';
  if (candidate.as_form) return 'an error in the form of her forces explains the runs as well';
  if (candidate.too_large) return 'larger than it can be: something else acts like it';
  if (candidate.trace) return 'too small to matter, or not told from none';
  return candidate.log_evidence_gain > 0 && candidate.log_evidence_gain < report.needed_gain ? 'gains less than a finding needs' : '';
}

function gainBar(gain, top) {
  const width = 100 * Math.max(0, gain) / top;
  return el('td', { class: 'gain' }, el('span', { class: 'bar', style: `width: ${width.toFixed(2)}%` }));
}

function candidateRow(candidate, report, top, withHeldOut) {
  const remark = remarkOf(candidate, report);
  const gain = candidate.log_evidence_gain;
  const cells = row(
    el('th', { scope: 'row' }, capital(nameOf(candidate.effect)), ' ', small(candidate.effect)),
    el('td', {}, fixed(gain, 1)), gainBar(gain, top),
    withHeldOut ? el('td', {}, isNumber(candidate.holdout_log_likelihood_gain) ? fixed(candidate.holdout_log_likelihood_gain, 1) : '') : null,
    el('td', {}, certainty(candidate.probability)),
    el('td', { class: 'words' }, remark));
  const isFound = report.effects.some(({ effect }) => effect === candidate.effect);
  cells.className = isFound ? 'found' : candidate.trace || candidate.too_large ? 'trace' : remark.startsWith('explains') ? 'rival' : '';
  return cells;
}

// One row for each effect that gains something or has a probability that rounds to more than nothing, its best try.
function bestTries(candidates) {
  const isShown = ({ log_evidence_gain: gain, probability }) => gain > 0 || probability >= 5e-4;
  return candidates.filter((candidate, i) => isShown(candidate) && candidates.findIndex(({ effect }) => effect === candidate.effect) === i);
}

function rankingSection(report) {
  const tried = bestTries(report.candidates);
  if (tried.length === 0) return null;
  const top = Math.max(1, ...tried.map(({ log_evidence_gain: gain }) => gain || 0));
  const needed = isNumber(report.needed_gain) ? ` A finding needs ${trimmed(report.needed_gain)}.` : '';
  const beside = report.effects.some(({ effect }) => tried.every((candidate) => candidate.effect !== effect)) ? ' Effects that are not in this list were found beside the first.' : '';
  const withHeldOut = tried.some(({ holdout_log_likelihood_gain: gain }) => isNumber(gain));
  const headings = [column('Effect, added alone'), column('Gain'), column(''), ...(withHeldOut ? [column('Held out')] : []), column('Probability'), el('th', { scope: 'col', style: 'text-align: left' }, '')];
  return el('section', { class: 'part', id: 'ranking' }, el('h2', {}, 'What could explain it'),
    table('ranking', headings, tried.map((candidate) => candidateRow(candidate, report, top, withHeldOut))),
    el('p', { class: 'note' }, `Gain: how much more probable the runs are with the effect, as a natural logarithm, its numbers and those of the model refitted.${needed} ` +
      `${withHeldOut ? 'Held out: the same for the likelihood of the held-out runs, without any refit, where it was asked. ' : ''}Probability: among these effects, each alone, and none of them.${beside}`));
}

// ---- what the missing force follows --------------------------------------------------------

const FOLLOWS = [
  ['form', 'motion, both sides alike'], ['form_asymmetric', 'motion, sides not alike'], ['earth_fixed', 'earth: wind, stream, waves'],
  ['delayed', 'past'], ['instruments', 'instruments'], ['unexplained', 'nothing known'],
];

function budgetRow(axis, shares) {
  const errors = shares.standard_error || {};
  return row(el('th', { scope: 'row' }, axis.name),
    ...FOLLOWS.map(([id]) => el('td', {}, `${percent(shares[id])} ± ${percent(errors[id])}`)), el('td', {}, digits(shares.size)));
}

function budgetSection({ budget }) {
  const rows = AXES.filter(({ id }) => budget && budget[id] && isNumber(budget[id].size)).map((axis) => budgetRow(axis, budget[axis.id]));
  if (rows.length === 0) return null;
  return el('section', { class: 'part', id: 'budget' }, el('h2', {}, 'What the missing force follows'),
    el('p', {}, 'The force that the model as given lacks, in shares of its mean square; size: its mean square over that of the force on the hull.'),
    scrolled(el('table', { class: 'stages' },
      el('thead', {}, row(el('th', { scope: 'col' }), ...FOLLOWS.map(([, words]) => el('th', { scope: 'col' }, words)), el('th', { scope: 'col' }, 'size'))),
      el('tbody', {}, ...rows))));
}

// ---- wind and stream by run --------------------------------------------------------------

function surroundingsText(part) {
  const numbers = Object.entries(part).filter(([, v]) => v && isNumber(v.value))
    .map(([key, v]) => {
      const { stem, unit, scale } = measured(key);
      const decimals = decimalsOf(v.standard_error * scale);
      return `${stem.replaceAll('_', ' ')} ${fixed(v.value * scale, decimals)} ± ${fixed(v.standard_error * scale, decimals)} ${unit}`;
    });
  return [numbers.join(', '), part.cannot_tell].filter(Boolean).join('; ');
}

function surroundingsSection({ surroundings }) {
  if (!surroundings || surroundings.length === 0) return null;
  return el('section', { class: 'part', id: 'surroundings' }, el('h2', {}, 'Surroundings'),
    el('table', { class: 'parameters' }, el('tbody', {}, ...surroundings.map((part) => row(
      el('th', { scope: 'row' }, part.scope.replace(/\.csv$/, '')), el('td', {}, surroundingsText(part)))))));
}

// ---- proof by replay ---------------------------------------------------------------------

const STAGES = [{ id: 'before', name: 'given' }, { id: 'refitted', name: 'refitted' }, { id: 'after', name: 'with effects' }];

const stagesOf = (report) => STAGES.filter(({ id }) => id !== 'after' || report.effects.length > 0);

function quantitiesIn(runs) {
  return Object.keys(QUANTITIES).filter((id) => runs.some((run) => STAGES.some((stage) => isNumber((run[stage.id] || {})[id]))));
}

const shadedShare = (fraction) => shaded(fraction, share(fraction));

function errorTable(runs, report) {
  const stages = stagesOf(report);
  const quantities = quantitiesIn(runs);
  const head = el('thead', {},
    row(el('th', { scope: 'col' }), ...quantities.map((id) => el('th', { scope: 'colgroup', colspan: stages.length, class: 'group' }, QUANTITIES[id]))),
    row(el('th', { scope: 'col' }, 'Run'), ...quantities.flatMap(() => stages.map(({ name }, i) => el('th', { scope: 'col', class: i === 0 ? 'group' : '' }, small(name))))));
  const cells = (run) => quantities.flatMap((id) => stages.map((stage) => shadedShare((run[stage.id] || {})[id])));
  const rows = runs.map((run) => row(el('th', { scope: 'row' }, run.run.replace(/\.csv$/, '')), ...cells(run)));
  return scrolled(el('table', { class: 'stages' }, head, el('tbody', {}, ...rows)));
}

// Error with the effects over error of the refitted model, the median of runs and quantities.
function ratioOf(runs) {
  const ratios = runs.flatMap((run) => Object.keys(QUANTITIES)
    .filter((id) => isNumber((run.after || {})[id]) && (run.refitted || {})[id] > 0)
    .map((id) => run.after[id] / run.refitted[id]));
  return ratios.length > 0 ? median(ratios) : null;
}

function ratioWords(runs, report, kind) {
  const ratio = report.effects.length > 0 ? ratioOf(runs) : null;
  return isNumber(ratio) ? el('p', {}, `With the effects, errors in the runs ${kind} are ${digits(ratio)} times those of the refitted model (median over runs and quantities).`) : null;
}

const replaysOf = (run) => REPLAYS.map((source) => ({ source, data: run.series[source.id] || {} })).filter(({ data }) => Object.values(data).some(has));

const wrappedDegrees = (angle) => angle - 360 * Math.round(angle / 360);

const headingError = (part, recorded) => (part === recorded ? null
  : combine((simulated, measuredPsi) => wrappedDegrees((simulated - measuredPsi) * DEGREES), part.psi_rad, recorded.psi_rad));

const PANELS = [
  { title: 'Heading, deg', values: (part) => inDegrees(part.psi_rad) },
  { title: 'Heading error, deg', values: headingError },
  { title: 'Yaw rate, deg/s', values: (part) => inDegrees(part.r_rad_s) },
  { title: 'Speed, m/s', values: (part) => part.u_m_s },
];

const isShown = (run, id) => !run.hidden || !run.hidden.has(id);

// Points where samples stand alone between missing ones, which no line would show.
function modeOf(values) {
  const there = values.map(isNumber);
  const alone = there.filter((here, i) => here && !there[i - 1] && !there[i + 1]).length;
  return alone > 0.5 * there.filter(Boolean).length ? 'markers' : 'lines';
}

function curve(run, source, x, y, more = {}) {
  return {
    type: 'scatter', mode: modeOf(y), x, y, name: source.label, meta: source.id, line: source.line, marker: { color: source.line.color, size: 3 },
    visible: isShown(run, source.id), connectgaps: false, ...more,
  };
}

function drawReplays(run, panels, report, node) {
  const turns = turnsOf(run, report);
  const { recorded = {} } = run.series;
  const traces = panels.flatMap((panel, i) => replaysOf(run).filter(({ data }) => has(panel.values(data, recorded)))
    .map(({ source, data }) => curve(run, source, run.series.time_s, panel.values(data, recorded), { yaxis: `y${i + 1}`, hovertemplate: '%{y:.4~g}' })));
  plot(node, traces, {
    margin: MARGIN,
    hovermode: 'x unified',
    xaxis: axis('Time, s', { anchor: `y${panels.length}`, hoverformat: '.1f' }),
    ...panelAxes(panels),
    shapes: turnLines(turns),
    annotations: turnLabels(turns, run),
  });
}

function hullTrace(run, source, part, length) {
  if (![part.x_m, part.y_m, part.psi_rad].every(has) || !isNumber(length)) return null;
  const corners = stations(part, length)
    .flatMap((i) => [...hullAt(part.x_m[i], part.y_m[i], part.psi_rad[i], length), [null, null]]);
  return curve(run, source, corners.map(([, east]) => east), corners.map(([north]) => north),
    { mode: 'lines', line: { color: source.line.color, width: 0.8 }, hoverinfo: 'skip' });
}

function drawTracks(run, length, node) {
  const parts = replaysOf(run).filter(({ data }) => has(data.x_m) && has(data.y_m));
  const paths = parts.map(({ source, data }) => curve(run, source, data.y_m, data.x_m, {
    customdata: run.series.time_s, text: run.series.time_s.map(seconds), hovertemplate: 'north %{y:.4~g} m, east %{x:.4~g} m<br>at %{text} s',
  }));
  const hulls = parts.filter(({ source }) => source.id === 'recorded').map(({ source, data }) => hullTrace(run, source, data, length));
  plot(node, [...paths, ...hulls.filter(Boolean)], {
    margin: MARGIN,
    hovermode: 'closest',
    xaxis: axis('East, m', { nticks: 7 }),
    yaxis: axis('North, m', { scaleanchor: 'x', scaleratio: 1, nticks: 10 }),
  });
}

function toggle(run, id, section) {
  run.hidden = run.hidden || new Set();
  if (!run.hidden.delete(id)) run.hidden.add(id);
  for (const node of section.querySelectorAll('.js-plotly-plot')) {
    const indices = node.data.flatMap((trace, index) => (trace.meta === id ? [index] : []));
    if (indices.length > 0) Plotly.restyle(node, { visible: isShown(run, id) }, indices);
  }
}

function replayKey(run, section) {
  return el('div', { class: 'key' }, ...replaysOf(run).map(({ source }) => {
    const box = el('input', { type: 'checkbox' });
    box.checked = true;
    box.addEventListener('change', () => toggle(run, source.id, section));
    const dash = source.line.dash ? (source.id === 'given' ? 'dotted' : 'dashed') : 'solid';
    return el('label', {}, box, el('span', { class: 'swatch', style: `border-color: ${source.line.color}; border-top-style: ${dash}` }), source.label);
  }));
}

function replayBlock(run, report) {
  const panels = PANELS.filter((panel) => replaysOf(run).some(({ data }) => has(panel.values(data, run.series.recorded || {}))));
  if (panels.length === 0) return null;
  const section = el('div', { class: 'block replay' }, runTitle(run));
  const track = replaysOf(run).some(({ data }) => has(data.x_m) && has(data.y_m))
    ? el('div', {}, plotBox('track', `Track of ${run.run}`, (node) => drawTracks(run, report.length_m, node), run.run)) : null;
  section.append(replayKey(run, section), el('div', { class: track ? 'plots' : 'plots single' },
    ...[el('div', {}, plotBox('replays', `Replays of ${run.run}`, (node) => drawReplays(run, panels, report, node), run.run)), track].filter(Boolean)));
  return section;
}

function replayGroup(title, runs, errors, report, kind) {
  if (runs.length === 0) return [];
  return [el('h3', { class: 'group-title' }, title), ratioWords(errors, report, kind), errors.length > 0 ? errorTable(errors, report) : null,
    ...runs.map((run) => replayBlock(run, report))].filter(Boolean);
}

function proofSection(report) {
  const heldOut = report.runs.filter((run) => run.held_out);
  const used = report.runs.filter((run) => !run.held_out);
  return el('section', { class: 'part', id: 'proof' }, el('h2', {}, 'Proof by replay'),
    heldOut.length === 0 ? el('p', {}, 'No run was held out: what follows are the runs that were used, which any added effect fits better.') : '',
    el('p', { class: 'note' }, 'Tables: the simulation takes up the recorded state every two ship lengths; root-mean-square error in per cent of the variation of the quantity in the run. ' +
      'Plots: one simulation from the start of the run to its end, steered by the recorded rudder.'),
    ...replayGroup('Runs held out', heldOut, report.fit.holdout, report, 'held out'),
    ...replayGroup('Runs used', used, report.fit.train, report, 'used'));
}

// ---- what to sail next -------------------------------------------------------------------

function detectableRow({ effect, parameter, value }) {
  const { stem, unit, scale } = measuredAs(parameter, value);
  return row(el('th', { scope: 'row' }, capital(nameOf(effect)), ' ', small(effect)), el('td', { class: 'words' }, ...symbol(stem)),
    el('td', {}, isNumber(value) ? digits(value * scale) : MISSING), el('td', { class: 'words' }, unit));
}

function detectableBlock(report) {
  if (!report.detectable || report.detectable.length === 0) return [];
  const words = (text) => el('th', { scope: 'col', style: 'text-align: left' }, text);
  return [el('h3', {}, 'Smallest sizes that these runs would have shown'),
    table('ranking detectable', [column('Effect'), words('Its number'), column('Smallest size'), words('Unit')], report.detectable.map(detectableRow))];
}

function nextBlock(next) {
  if (!next || !next.advice) return [];
  return [el('p', { class: 'verdict' }, capital(inWords(next.advice))),
    next.separates && next.separates.length > 0 ? el('p', {}, `It tells apart: ${namesOf(next.separates)}.`) : null].filter(Boolean);
}

function nextSection(report) {
  const blocks = [...nextBlock(report.next_manoeuvre), ...detectableBlock(report)];
  if (blocks.length === 0) return null;
  const title = report.next_manoeuvre ? 'What to sail next' : 'What these runs would have shown';
  return el('section', { class: 'part', id: 'next' }, el('h2', {}, title), ...blocks);
}

// ---- the page ----------------------------------------------------------------------------

function cards(report) {
  return report.effects.length > 0 ? [el('div', { class: 'cards' }, ...report.effects.map(effectCard))] : [];
}

function jumpList(sections) {
  return el('nav', { class: 'jump parts', 'aria-label': 'Parts' },
    ...sections.map((section) => el('a', { href: `#${section.id}` }, section.querySelector('h2').textContent)), el('a', { href: '#report' }, 'Top'));
}

function footer(report) {
  return el('footer', {},
    el('p', {}, el('strong', {}, 'Method. '),
      'A filter sails the model along each run and carries, beside position and motion, the acceleration that the model leaves out. Every effect that is known is tried; ' +
      'the numbers of the model may shift within their confidence, so that a slightly wrong coefficient is not called wind. Held-out runs are never used in a fit.'),
    el('p', {}, el('strong', {}, 'Signs. '),
      'Heading and yaw rate are positive to starboard, rudder angle to port. The drift angle is positive when the bow points to starboard of the course, as in a turn to starboard. ' +
      'Wind and waves are told by where they come from, current by where it goes, clockwise from north.'),
    el('p', {}, `Made by swayaw ${report.version || ''}. Plots by Plotly.js, MIT licence; the camera saves them as SVG.`));
}

function preparedReport(report) {
  const runs = (report.runs || []).map((run) => ({ ...run, series: run.series || {} }));
  const { location = [], effects = [], candidates = [], fit = {} } = report;
  return { ...report, runs, location, effects, candidates, fit: { train: fit.train || [], holdout: fit.holdout || [] } };
}

function showDiagnosis(report) {
  EFFECTS = report.effect_names || {};
  nameAfter(report.verdict);
  const sections = [budgetSection, surroundingsSection, forceSection, planeSection, rankingSection, proofSection, nextSection].map((make) => make(report)).filter(Boolean);
  document.getElementById('report').append(...cards(report), jumpList(sections), ...sections, footer(report));
  renderWhenNear();
}

showAfterPaint((report) => showDiagnosis(preparedReport(report)));
