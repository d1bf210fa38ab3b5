const QUANTITIES = {
  heading: { name: 'Heading', unit: 'deg', scale: DEGREES },
  yaw_rate: { name: 'Yaw rate', unit: 'deg/s', scale: DEGREES },
  speed: { name: 'Speed', unit: 'm/s', scale: 1 },
  drift: { name: 'Drift angle', unit: 'deg', scale: DEGREES },
  sway_velocity: { name: 'Sway velocity', unit: 'm/s', scale: 1 },
  position: { name: 'Position', unit: 'm', scale: 1 },
};

const REGIONS = {
  drift: { title: 'Drift angle, deg', scale: DEGREES },
  yaw_rate: { title: 'Yaw rate r′ = r L / U', scale: 1 },
  rudder: { title: 'Rudder, deg (port positive)', scale: DEGREES },
};

const SOURCES = [
  { id: 'recorded', label: 'Recorded', line: { color: '#2b2b2b', width: 2.1 } },
  { id: 'open_loop', label: 'Simulated, whole run', line: { color: '#0072b2', width: 1.7, dash: '6px,3px' } },
  { id: 'windows', label: 'Simulated, restarted', line: { color: '#e07b00', width: 1.9 } },
];

const JUMP_LIST_ABOVE = 3;
const PANEL_HEIGHT = 158;

// ---- words and numbers -------------------------------------------------------------------

function shipLengths(count) {
  const words = ['', 'one', 'two', 'three', 'four', 'five', 'six'];
  return `${words[count] || trimmed(count)} ship length${count === 1 ? '' : 's'}`;
}

function kindOf(id) {
  return QUANTITIES[id] || { name: id.replaceAll('_', ' '), unit: '', scale: 1 };
}

function nameWithUnit(id) {
  const { name, unit } = kindOf(id);
  return unit ? `${name}, ${unit}` : name;
}

// ---- channels ----------------------------------------------------------------------------

function driftOf(part) {
  return inDegrees(part.drift_rad) || combine((u, v) => Math.atan2(-v, u) * DEGREES, part.u_m_s, part.v_m_s);
}

// U from u and v, or from u and the drift angle.
function totalSpeed(part) {
  return combine(Math.hypot, part.u_m_s, part.v_m_s) ||
    combine((u, beta) => u / Math.cos(beta), part.u_m_s, part.drift_rad);
}

// r' = r L / U, left out where the ship hardly moves.
function primeYawRate(part, length) {
  const speed = totalSpeed(part) || part.u_m_s;
  if (!has(speed) || !isNumber(length)) return null;
  const slow = 0.05 * speed.reduce((top, U) => Math.max(top, U || 0), 0);
  return combine((r, U) => (U > slow ? (r * length) / U : null), part.r_rad_s, speed);
}

function partsOf(run) {
  const series = run.series || {};
  return SOURCES.map((source) => ({ source, data: series[source.id] || {} }));
}

function speedPanel(recorded) {
  if (totalSpeed(recorded)) return { title: 'Speed, m/s', values: totalSpeed, quantity: 'speed' };
  return { title: 'Ahead speed, m/s', values: (part) => part.u_m_s, quantity: 'speed' };
}

function sidewaysPanel(recorded) {
  if (driftOf(recorded)) return { title: 'Drift, deg', values: driftOf, quantity: 'drift' };
  return { title: 'Sway, m/s', values: (part) => part.v_m_s, quantity: 'sway_velocity' };
}

// A simulation steered by the recorded rudder repeats it; only a differing rudder is drawn.
function rudderPanel(recorded) {
  const measured = inDegrees(recorded.delta_rad);
  const differs = (values) => !measured ||
    values.some((value, i) => isNumber(value) && isNumber(measured[i]) && Math.abs(value - measured[i]) > 0.1);
  const values = (part) => {
    const rudder = inDegrees(part.delta_rad);
    return part === recorded || (rudder && differs(rudder)) ? rudder : null;
  };
  return { title: 'Rudder, deg', values, quantity: null };
}

function panelsOf(run) {
  const recorded = partsOf(run)[0].data;
  const panels = [
    { title: 'Heading, deg', values: (part) => inDegrees(part.psi_rad), quantity: 'heading' },
    { title: 'Yaw rate, deg/s', values: (part) => inDegrees(part.r_rad_s), quantity: 'yaw_rate' },
    speedPanel(recorded),
    sidewaysPanel(recorded),
    rudderPanel(recorded),
  ];
  return panels.filter((panel) => has(panel.values(recorded)));
}

// ---- plots -------------------------------------------------------------------------------

function isShown(run, id) {
  return !run.hidden || !run.hidden.has(id);
}

function line(run, source, x, y, more = {}) {
  return {
    type: 'scatter', mode: 'lines', x, y, name: source.label, meta: source.id, line: source.line,
    visible: isShown(run, source.id), connectgaps: false, ...more,
  };
}

function worstOf(run, quantityId) {
  const found = (run.quantities || []).find((quantity) => quantity.quantity === quantityId);
  return found && found.worst && isNumber(found.worst.from_s) ? found.worst : null;
}

function worstShade(run, panel, index) {
  const worst = worstOf(run, panel.quantity);
  if (!worst) return null;
  return {
    type: 'rect', layer: 'below', xref: 'x', yref: `y${index + 1} domain`, fillcolor: WORST_FILL,
    line: { width: 0 }, x0: worst.from_s, x1: worst.to_s, y0: 0, y1: 1,
  };
}

function panelTraces(run, panel, index) {
  const hovertemplate = '%{y:.4~g}';
  return partsOf(run)
    .map(({ source, data }) => ({ source, values: panel.values(data) }))
    .filter(({ values }) => has(values))
    .map(({ source, values }) =>
      line(run, source, run.series.time_s, values, { yaxis: `y${index + 1}`, hovertemplate }));
}

function drawTimeSeries(run, panels, node) {
  const bottom = `y${panels.length}`;
  plot(node, panels.flatMap((panel, index) => panelTraces(run, panel, index)), {
    margin: MARGIN,
    hovermode: 'x unified',
    xaxis: axis('Time, s', {
      anchor: bottom, hoverformat: '.1f',
      showspikes: true, spikemode: 'across', spikethickness: 1, spikedash: 'solid', spikecolor: '#8b949e',
    }),
    ...panelAxes(panels),
    shapes: panels.map((panel, index) => worstShade(run, panel, index)).filter(Boolean),
  });
}

function hullTrace(run, source, part, length) {
  if (![part.x_m, part.y_m, part.psi_rad].every(has) || !isNumber(length)) return null;
  const corners = stations(part, length)
    .flatMap((i) => [...hullAt(part.x_m[i], part.y_m[i], part.psi_rad[i], length), [null, null]]);
  return line(run, source, corners.map((corner) => corner[1]), corners.map((corner) => corner[0]),
    { line: { color: source.line.color, width: 0.8 }, hoverinfo: 'skip' });
}

function worstStretch(run) {
  const worst = worstOf(run, 'position');
  const { x_m: north, y_m: east } = run.series.recorded;
  if (!worst || !has(north)) return null;
  const inside = run.series.time_s.map((time) => time >= worst.from_s && time <= worst.to_s);
  const only = (channel) => channel.map((value, i) => (inside[i] ? value : null));
  return {
    type: 'scatter', mode: 'lines', x: only(east), y: only(north), hoverinfo: 'skip',
    line: { color: WORST_FILL, width: 16 },
  };
}

function trackTraces(run, length) {
  const parts = partsOf(run).filter(({ data }) => has(data.x_m) && has(data.y_m));
  const paths = parts.map(({ source, data }) => line(run, source, data.y_m, data.x_m, {
    customdata: run.series.time_s, text: run.series.time_s.map((time) => seconds(time)),
    hovertemplate: 'north %{y:.4~g} m, east %{x:.4~g} m<br>at %{text} s',
  }));
  const hulls = parts.filter(({ source }) => source.id !== 'windows')
    .map(({ source, data }) => hullTrace(run, source, data, length));
  return [worstStretch(run), ...paths, ...hulls].filter(Boolean);
}

function drawTrack(run, length, node) {
  plot(node, trackTraces(run, length), {
    margin: MARGIN,
    hovermode: 'closest',
    xaxis: axis('East, m', { nticks: 8 }),
    yaxis: axis('North, m', { scaleanchor: 'x', scaleratio: 1, nticks: 10 }),
  });
}

function drawPhase(run, length, node) {
  const prime = has(primeYawRate(run.series.recorded, length));
  const yawRate = (part) => (prime ? primeYawRate(part, length) : inDegrees(part.r_rad_s));
  const traces = partsOf(run)
    .map(({ source, data }) => ({ source, drift: driftOf(data), rate: yawRate(data) }))
    .filter(({ drift, rate }) => has(drift) && has(rate))
    .map(({ source, drift, rate }) => line(run, source, drift, rate, {
      customdata: run.series.time_s, hovertemplate: 'drift %{x:.3~g} deg, yaw rate %{y:.3~g}',
    }));
  plot(node, traces, {
    margin: MARGIN,
    hovermode: 'closest',
    xaxis: axis('Drift angle, deg'),
    yaxis: axis(prime ? REGIONS.yaw_rate.title : 'Yaw rate, deg/s'),
  });
}

// ---- error by region ---------------------------------------------------------------------

function regionLabel(region) {
  const { scale } = REGIONS[region.variable];
  const edge = (value) => trimmed(value * scale);
  if (!isNumber(region.from) && !isNumber(region.to)) return 'all';
  if (!isNumber(region.from)) return `below ${edge(region.to)}`;
  if (!isNumber(region.to)) return `above ${edge(region.from)}`;
  return `${edge(region.from)} to ${edge(region.to)}`;
}

function errorSpan(quantity) {
  const { scale } = kindOf(quantity.quantity);
  const values = quantity.by_region.flatMap((region) => [region.rms, region.bias]).filter(isNumber);
  const top = Math.max(0, quantity.window_rms || 0, ...values) * scale;
  const bottom = Math.min(0, ...values) * scale;
  const margin = 0.08 * (top - bottom || 1);
  return [bottom < 0 ? bottom - margin : 0, top + margin];
}

function isRare(region, regions) {
  const all = regions.reduce((sum, { samples }) => sum + samples, 0);
  return region.samples < 0.01 * all;
}

// Regions in rising order; the ends are open, so a missing edge stands for infinity.
function inOrder(regions) {
  const edge = (value) => (isNumber(value) ? value : -Infinity);
  return [...regions].sort((a, b) => edge(a.from) - edge(b.from));
}

// One place on the axis for each region, and an empty one where ranges without samples lie between.
function placed(regions) {
  let place = 0;
  return inOrder(regions).map((region, index, all) => {
    if (index > 0) place += all[index - 1].to === region.from ? 1 : 2;
    return { region, place };
  });
}

// The edges of the ranges, written between the bars.
function edgeTicks(places, scale) {
  const labels = new Map();
  for (const { region, place } of places) {
    if (isNumber(region.from)) labels.set(place - 0.5, trimmed(region.from * scale));
    if (isNumber(region.to)) labels.set(place + 0.5, trimmed(region.to * scale));
  }
  return { tickmode: 'array', tickvals: [...labels.keys()], ticktext: [...labels.values()] };
}

function regionTraces(places, quantity) {
  const { scale, unit } = kindOf(quantity.quantity);
  const scaled = (value) => (isNumber(value) ? value * scale : null);
  const regions = places.map(({ region }) => region);
  const x = places.map(({ place }) => place);
  const words = regions.map((region) => `${regionLabel(region)}, ${counted(region.samples, 'sample')}`);
  return [
    {
      type: 'bar', x, y: regions.map((region) => scaled(region.rms)), text: words, textposition: 'none',
      marker: { color: regions.map((region) => (isRare(region, regions) ? '#f5d3a8' : '#e07b00')) },
      hovertemplate: `%{text}<br>error %{y:.3~g} ${unit}<extra></extra>`,
    },
    {
      type: 'scatter', mode: 'markers', x, y: regions.map((region) => scaled(region.bias)), text: words,
      marker: { symbol: 'diamond', size: 9, color: '#2b2b2b', line: { color: '#fff', width: 1 } },
      hovertemplate: `%{text}<br>bias %{y:.3~g} ${unit}<extra></extra>`,
    },
  ];
}

function overallLine(quantity) {
  const level = quantity.window_rms * kindOf(quantity.quantity).scale;
  return {
    type: 'line', xref: 'paper', x0: 0, x1: 1, y0: level, y1: level,
    line: { color: '#5a6470', width: 1.2, dash: 'dot' },
  };
}

function drawRegions(variable, quantity, node) {
  const { title, scale } = REGIONS[variable];
  const places = placed(quantity.by_region.filter((region) => region.variable === variable));
  plot(node, regionTraces(places, quantity), {
    margin: { ...MARGIN, r: 16, t: 8 },
    bargap: 0.12,
    dragmode: false,
    xaxis: axis(title, {
      ...edgeTicks(places, scale), tickfont: { size: 11 }, automargin: true,
      fixedrange: true, showgrid: false, zeroline: false,
    }),
    yaxis: axis(`Error, ${kindOf(quantity.quantity).unit}`, {
      range: errorSpan(quantity), fixedrange: true, nticks: 6,
    }),
    shapes: isNumber(quantity.window_rms) ? [overallLine(quantity)] : [],
  }, { displayModeBar: false });
}

// Position stands back: its variation is the length of the track, so its error always looks small.
function largest(quantities) {
  const motions = quantities.filter(({ quantity }) => quantity !== 'position');
  return motions.reduce((worst, quantity) =>
    ((quantity.normalised || 0) > (worst.normalised || 0) ? quantity : worst), motions[0] || quantities[0]);
}

function quantityChoice(quantities, chosen, onChange) {
  const options = quantities.map(({ quantity }) => el('option', { value: quantity }, kindOf(quantity).name));
  const select = el('select', { 'aria-label': 'Quantity' }, ...options);
  select.value = chosen.quantity;
  select.addEventListener('change', () =>
    onChange(quantities.find(({ quantity }) => quantity === select.value)));
  return select;
}

function regionBlock(run) {
  const quantities = run.quantities.filter(({ by_region }) => by_region && by_region.length > 0);
  if (quantities.length === 0) return null;
  let chosen = largest(quantities);
  const variables = Object.keys(REGIONS).filter((variable) =>
    quantities.some(({ by_region }) => by_region.some((region) => region.variable === variable)));
  const boxes = variables.map((variable) =>
    plotBox('bars', `Error by ${variable.replace('_', ' ')}`, (node) => drawRegions(variable, chosen, node)));
  const redraw = (quantity) => {
    chosen = quantity;
    boxes.forEach((box, i) => pending.has(box) || drawRegions(variables[i], chosen, box));
  };
  return el('div', { class: 'block' },
    el('h3', {}, 'Where the error is: ', quantityChoice(quantities, chosen, redraw)),
    el('p', { class: 'note' }, 'Bars: window error of the samples in each range. Diamonds: bias there, ' +
      'simulated minus recorded. Dotted line: window error of all samples. Pale: less than 1 % of the samples.'),
    el('div', { class: 'regions' }, ...boxes));
}

// ---- tables ------------------------------------------------------------------------------

function quantityOrder(runs) {
  const present = new Set(runs.flatMap((run) => run.quantities.map(({ quantity }) => quantity)));
  const known = Object.keys(QUANTITIES).filter((id) => present.delete(id));
  return [...known, ...present];
}

function normalisedOf(quantities, id) {
  const found = quantities.find(({ quantity }) => quantity === id);
  return found ? found.normalised : null;
}

function summaryRow(run, order) {
  const link = (words) => el('a', { href: `#${run.id}` }, words);
  const cell = (fraction) => shaded(fraction, link(percent(fraction)));
  return row(
    el('th', { scope: 'row' }, link(run.run), run.manoeuvre ? small(run.manoeuvre) : null),
    ...order.map((id) => cell(normalisedOf(run.quantities, id))));
}

function togetherRow(quantities, order) {
  const cell = (fraction) => shaded(fraction, el('span', {}, percent(fraction)));
  const together = row(el('th', { scope: 'row' }, 'All runs'),
    ...order.map((id) => cell(normalisedOf(quantities, id))));
  together.className = 'together';
  return together;
}

function summaryTable(report) {
  const order = quantityOrder(report.runs);
  const rows = report.runs.map((run) => summaryRow(run, order));
  const together = report.all_runs && report.all_runs.quantities;
  if (together && report.runs.length > 1) rows.push(togetherRow(together, order));
  return table('summary', [column('Run'), ...order.map((id) => column(kindOf(id).name))], rows);
}

function intervalCell(worst) {
  if (!worst) return el('td', {}, MISSING);
  return el('td', {}, between(worst.from_s, worst.to_s), ' ', small(`(${percent(worst.share)})`));
}

function regionCell(region) {
  if (!region) return el('td', { class: 'words' }, MISSING);
  return el('td', { class: 'words' }, region.words || MISSING, ' ', small(`(${percent(region.share)})`));
}

function errorRow(quantity, withNoise) {
  const { scale } = kindOf(quantity.quantity);
  const number = (value) => el('td', {}, digits(isNumber(value) ? value * scale : null));
  return row(
    el('th', { scope: 'row' }, nameWithUnit(quantity.quantity)),
    number(quantity.window_rms),
    shaded(quantity.normalised),
    number(quantity.bias),
    withNoise ? number(quantity.noise) : null,
    number(quantity.open_loop_rms),
    el('td', {}, percent(quantity.open_loop_normalised)),
    intervalCell(quantity.worst),
    regionCell(quantity.region));
}

function errorBlock(run) {
  const withNoise = run.quantities.some(({ noise }) => isNumber(noise));
  const headings = [column('Quantity'), column('Window error'), column('normalised'), column('Bias'),
    withNoise ? column('Noise') : null, column('Whole\u2011run error'), column('normalised'),
    column('Worst interval'), el('th', { scope: 'col', style: 'text-align:left' }, 'Worst region')];
  return el('div', { class: 'block' },
    el('h3', {}, 'Error of each quantity'),
    table('errors', headings, run.quantities.map((quantity) => errorRow(quantity, withNoise))),
    el('p', { class: 'note' }, 'Errors are root mean square. Bias is the mean of simulated minus recorded. ' +
      (withNoise ? 'Noise is the scatter of the recording itself. ' : '') +
      'In brackets: the share of the squared window error found there.'));
}

// ---- a run -------------------------------------------------------------------------------

function restyle(node, id, shown) {
  const indices = node.data.flatMap((trace, index) => (trace.meta === id ? [index] : []));
  if (indices.length > 0) Plotly.restyle(node, { visible: shown }, indices);
}

function toggle(run, id, section) {
  run.hidden = run.hidden || new Set();
  if (!run.hidden.delete(id)) run.hidden.add(id);
  for (const node of section.querySelectorAll('.js-plotly-plot')) restyle(node, id, isShown(run, id));
}

function keyEntry(run, source, section, lengths) {
  const box = el('input', { type: 'checkbox' });
  box.checked = true;
  box.addEventListener('change', () => toggle(run, source.id, section));
  return el('label', {}, box, el('span', { class: `swatch ${source.id}` }),
    source.id === 'windows' ? `${source.label} every ${lengths}` : source.label);
}

function key(run, section, lengths) {
  const entries = partsOf(run).filter(({ data }) => Object.values(data).some(has))
    .map(({ source }) => keyEntry(run, source, section, lengths));
  const worst = el('label', {}, el('span', { class: 'swatch worst' }), 'Worst interval of that quantity');
  return el('div', { class: 'key' }, ...entries, run.quantities.some((quantity) => quantity.worst) ? worst : null);
}

function titled(title, box) {
  return el('div', {}, el('h3', {}, title), box);
}

function timeSeriesBox(run) {
  const panels = panelsOf(run);
  if (panels.length === 0) return null;
  const box = plotBox('time', 'Time series', (node) => drawTimeSeries(run, panels, node), run.id);
  box.style.height = `${panels.length * PANEL_HEIGHT + MARGIN.t + MARGIN.b}px`;
  return titled('Against time', box);
}

function trackBox(run, length) {
  if (!partsOf(run).some(({ data }) => has(data.x_m) && has(data.y_m))) return null;
  return titled('Track', plotBox('track', 'Track', (node) => drawTrack(run, length, node), run.id));
}

function phaseBox(run, length) {
  const { recorded } = run.series;
  if (!driftOf(recorded) || !has(recorded.r_rad_s)) return null;
  return titled('Drift angle and yaw rate',
    plotBox('phase', 'Drift angle and yaw rate', (node) => drawPhase(run, length, node), run.id));
}

function absentNote(run) {
  const { recorded } = run.series;
  const absent = [
    [has(recorded.x_m) && has(recorded.y_m), 'position'], [has(recorded.r_rad_s), 'yaw rate'],
    [has(recorded.u_m_s), 'speed'], [driftOf(recorded), 'drift angle'], [has(recorded.delta_rad), 'rudder angle'],
  ].filter(([present]) => !present).map(([, name]) => name);
  return absent.length > 0 ? el('p', { class: 'note' }, `Not in this recording: ${absent.join(', ')}.`) : null;
}

function plotsBlock(run, length) {
  const side = [trackBox(run, length), phaseBox(run, length)].filter(Boolean);
  const beside = side.length > 0 ? el('div', { class: 'side' }, ...side) : null;
  const columns = [timeSeriesBox(run), beside].filter(Boolean);
  return el('div', { class: columns.length > 1 ? 'plots' : 'plots single' }, ...columns);
}

function factsOf(run) {
  const facts = [run.manoeuvre, isNumber(run.duration_s) ? `${seconds(run.duration_s)} s` : null,
    isNumber(run.samples) ? counted(run.samples, 'sample') : null,
    isNumber(run.windows) ? counted(run.windows, 'window') : null];
  return facts.filter(Boolean).join(' · ');
}

function headline(run) {
  if (run.quantities.length === 0) return null;
  const worst = largest(run.quantities);
  if (!isNumber(worst.normalised)) return null;
  const when = worst.worst ? `; worst from ${between(worst.worst.from_s, worst.worst.to_s)}` : '';
  const name = kindOf(worst.quantity).name.toLowerCase();
  return el('p', {}, `Largest window error: ${name}, ${percent(worst.normalised)}${when}.`);
}

function runSection(run, ship) {
  const section = el('section', { class: 'run', id: run.id },
    el('h2', {}, run.run), el('p', { class: 'facts' }, factsOf(run)));
  const parts = [headline(run)];
  if (run.series) parts.push(key(run, section, ship.lengths), absentNote(run), plotsBlock(run, ship.length));
  if (run.quantities.length > 0) parts.push(errorBlock(run), regionBlock(run));
  section.append(...parts.filter(Boolean));
  return section;
}

// ---- the page ----------------------------------------------------------------------------

function summary(report, lengths) {
  return el('section', {},
    el('h3', {}, 'Window error of each run'),
    summaryTable(report),
    el('p', { class: 'note' }, `Simulation restarted every ${lengths}; error in per cent of the quantity's own ` +
      'variation in the run. Deeper colour: larger error.'));
}

function jumpList(runs) {
  return el('nav', { class: 'jump', 'aria-label': 'Runs' }, el('span', {}, 'Jump to run'),
    ...runs.map((run) => el('a', { href: `#${run.id}`, title: run.run }, run.run.replace(/\.csv$/, ''))),
    el('a', { href: '#report' }, 'Top'));
}

function footer(report, lengths) {
  return el('footer', {},
    el('p', {}, el('strong', {}, 'Window error. '),
      `The simulation is restarted from the recorded state every ${lengths} travelled, and compared with the ` +
      'recording until the next restart. So an error shows where the model is wrong, instead of piling up from ' +
      'everything that went wrong before. Normalised: divided by the quantity\'s own root-mean-square variation ' +
      'in the run.'),
    el('p', {}, el('strong', {}, 'Whole-run error. '),
      'The simulation starts once, from the first recorded state, and is steered by the recorded rudder to the end.'),
    el('p', {}, el('strong', {}, 'Signs. '),
      'Heading and yaw rate are positive to starboard, rudder angle to port. The drift angle is positive ' +
      'when the bow points to starboard of the course, as in a turn to starboard.'),
    el('p', {}, `Made by swayaw ${report.version || ''}. Plots by Plotly.js, MIT licence.`));
}

function prepared(report) {
  const runs = (report.runs || []).map((run, index) => {
    const series = run.series ? { ...run.series, recorded: run.series.recorded || {} } : null;
    return { ...run, id: `run-${index + 1}`, quantities: run.quantities || [], series };
  });
  return { ...report, runs };
}

function show(report) {
  const lengths = shipLengths(report.window_ship_lengths || 2);
  const ship = { length: report.length_m, lengths };
  document.getElementById('report').append(
    summary(report, lengths),
    ...(report.runs.length > JUMP_LIST_ABOVE ? [jumpList(report.runs)] : []),
    ...report.runs.map((run) => runSection(run, ship)), footer(report, lengths));
  renderWhenNear();
}

showAfterPaint((report) => show(prepared(report)));
