// The page of a drift–yaw loop: indices, zigzag, loop, sensitivity, map.

const COLORS = { drift: '#0072b2', yaw: '#e07b00', rudder: '#5a6470', heading: '#2b2b2b', line: '#009e73' };

const MEASURES = {
  area: { name: 'Area of the loop', unit: 'rad', scale: 1 },
  length: { name: 'Length', unit: '', scale: 1 },
  width: { name: 'Width', unit: '', scale: 1 },
  inclination_rad: { name: 'Inclination', unit: 'deg', scale: DEGREES },
  beta_max_rad: { name: 'Largest drift angle', unit: 'deg', scale: DEGREES },
  omega_max: { name: 'Largest yaw rate ω′', unit: '', scale: 1 },
  omega_at_beta_zero: { name: 'ω′ where drift is zero', unit: '', scale: 1 },
  beta_at_omega_zero_rad: { name: 'Drift where ω′ is zero', unit: 'deg', scale: DEGREES },
  distance_from_line: { name: 'Distance from the first-order line', unit: '', scale: 1 },
  period: { name: 'Period', unit: 'L/U', scale: 1 },
  first_overshoot_deg: { name: 'First overshoot', unit: 'deg', scale: 1 },
  second_overshoot_deg: { name: 'Second overshoot', unit: 'deg', scale: 1 },
};

const withUnit = ({ name, unit }) => (unit ? `${name}, ${unit}` : name);

function trace(x, y, color, name, more = {}) {
  return { type: 'scatter', mode: 'lines', x, y, name, line: { color, width: 1.9 }, ...more };
}

// A derivative of which only rounding is left is zero.
const unlessRounding = (derivative, value) =>
  (isNumber(derivative) && Math.abs(derivative) < 1e-10 * Math.abs(value) ? 0 : derivative);

// ---- tables ------------------------------------------------------------------------------

function indexTable(indices) {
  const names = ['T1', 'T2', 'T3b', 'T3w', 'Kb', 'Kw', 'T_b', 'T_w'];
  const shown = names.filter((name) => name in indices);
  return table('summary', [column(''), ...shown.map((name) => column(name))],
    [row(el('th', { scope: 'row' }, 'In ship lengths'), ...shown.map((name) => el('td', {}, el('span', {}, digits(indices[name])))))]);
}

function measureRow(report, id) {
  const measure = MEASURES[id];
  const of = (values) => (values && isNumber(values[id]) ? values[id] * measure.scale : null);
  const value = of(report.loop);
  const sensitivity = report.sensitivity || {};
  return row(
    el('th', { scope: 'row' }, withUnit(measure)),
    el('td', {}, digits(value)),
    el('td', {}, digits(unlessRounding(of(sensitivity.T3b), value))),
    el('td', {}, digits(unlessRounding(of(sensitivity.T3w), value))));
}

function overshootRows(report) {
  const sensitivity = report.sensitivity || {};
  const of = (values, i) => digits(values && values.overshoot_deg
    ? unlessRounding(values.overshoot_deg[i], report.overshoot_deg[i]) : null);
  return (report.overshoot_deg || []).slice(0, 4).map((value, i) => row(
    el('th', { scope: 'row' }, `Overshoot ${i + 1}, deg`),
    el('td', {}, digits(value)), el('td', {}, of(sensitivity.T3b, i)), el('td', {}, of(sensitivity.T3w, i))));
}

function measureTable(report) {
  const rows = Object.keys(MEASURES).filter((id) => isNumber(report.loop[id])).map((id) => measureRow(report, id));
  return table('errors', [column('Measure'), column('Value'), column('by T3b'), column('by T3w')],
    [...rows, ...overshootRows(report)]);
}

// ---- plots -------------------------------------------------------------------------------

function drawZigzag({ zigzag }, node) {
  const s = zigzag.s;
  plot(node, [
    trace(s, inDegrees(zigzag.psi_rad), COLORS.heading, 'heading'),
    trace(s, inDegrees(zigzag.delta_rad), COLORS.rudder, 'rudder, to port'),
    trace(s, inDegrees(zigzag.beta_rad), COLORS.drift, 'drift angle', { yaxis: 'y2' }),
    trace(s, zigzag.omega, COLORS.yaw, 'ω′', { yaxis: 'y3' }),
  ], {
    margin: { ...MARGIN, b: 70 },
    hovermode: 'x unified',
    showlegend: true,
    legend: { orientation: 'h', y: -0.16 },
    xaxis: axis('Ship lengths sailed', { anchor: 'y3' }),
    yaxis: axis('Heading, rudder, deg', { domain: [0.56, 1] }),
    yaxis2: axis('Drift, deg', { domain: [0.29, 0.52] }),
    yaxis3: axis('ω′', { domain: [0, 0.25] }),
  });
}

function drawLoop({ zigzag, cycle, slope }, node) {
  const reach = cycle.beta_rad.reduce((top, beta) => Math.max(top, Math.abs(beta || 0)), 0);
  const ends = [-reach, reach];
  plot(node, [
    trace(ends.map((beta) => beta * DEGREES), ends.map((beta) => beta * slope), COLORS.line, 'first-order line',
      { line: { color: COLORS.line, width: 1.4, dash: '6px,3px' } }),
    trace(inDegrees(zigzag.beta_rad), zigzag.omega, '#b9c0c8', 'from straight ahead', { line: { color: '#b9c0c8', width: 1.2 } }),
    trace(inDegrees(cycle.beta_rad), cycle.omega, COLORS.yaw, 'last cycle', { line: { color: COLORS.yaw, width: 2.4 } }),
  ], {
    margin: { ...MARGIN, b: 70 },
    hovermode: 'closest',
    showlegend: true,
    legend: { orientation: 'h', y: -0.16 },
    xaxis: axis('Drift angle, deg'),
    yaxis: axis('Yaw rate ω′'),
  });
}

function cellsOf(map, values) {
  return map.T3w.flatMap((T3w, i) => map.T3b.map((T3b, j) => ({ T3b, T3w, value: values[i][j] })))
    .filter(({ value }) => isNumber(value));
}

function drawMap({ map, indices }, id, node) {
  const measure = MEASURES[id];
  const cells = cellsOf(map, map.measures[id]);
  const side = Math.max(3, 0.82 * (node.clientWidth - MARGIN.l - 90) / map.T3b.length);
  plot(node, [
    {
      type: 'scatter', mode: 'markers', x: cells.map(({ T3b }) => T3b), y: cells.map(({ T3w }) => T3w),
      text: cells.map(({ value }) => digits(value * measure.scale)),
      marker: {
        symbol: 'square', size: side, color: cells.map(({ value }) => value * measure.scale), colorscale: 'Viridis',
        showscale: true, colorbar: { title: { text: withUnit(measure), side: 'right' }, thickness: 14 },
      },
      hovertemplate: 'T3b %{x:.3~g}, T3w %{y:.3~g}<br>%{text}<extra></extra>',
    },
    {
      type: 'scatter', mode: 'markers', x: [indices.T3b], y: [indices.T3w], hovertemplate: 'this ship<extra></extra>',
      marker: { symbol: 'cross', size: 15, color: '#fff', line: { color: '#1b1f24', width: 1.5 } },
    },
  ], {
    margin: { ...MARGIN, r: 60 },
    hovermode: 'closest',
    xaxis: axis('T3b, ship lengths'),
    yaxis: axis('T3w, ship lengths'),
  });
}

// ---- the page ----------------------------------------------------------------------------

function titledBox(title, box, note = null) {
  return el('div', {}, el('h3', {}, title), box, note ? el('p', { class: 'note' }, note) : null);
}

function mapBlock(report) {
  const present = Object.keys(MEASURES).filter((id) => report.map.measures[id]);
  const select = el('select', { 'aria-label': 'Measure' },
    ...present.map((id) => el('option', { value: id }, MEASURES[id].name)));
  const box = plotBox('bars map', 'Map over T3b and T3w', (node) => drawMap(report, select.value, node));
  select.addEventListener('change', () => drawMap(report, select.value, box));
  return el('div', { class: 'block' }, el('h3', {}, 'Over T3b and T3w: ', select), box,
    el('p', { class: 'note' }, 'The other four indices are those of the ship (cross). Near the diagonal T3b = T3w no ship exists.'));
}

function footer(report) {
  return el('footer', {},
    el('p', {}, el('strong', {}, 'Loop. '),
      'Drift angle and yaw rate ω′ = rL/U over the last full cycle of the zigzag. Length, width and inclination are those of ' +
      'the ellipse with the same area moments. A first-order ship draws a straight line; the width of the loop is what ' +
      'T3b and T3w do. Time in ship lengths.'),
    el('p', {}, el('strong', {}, 'Signs. '),
      'Heading and yaw rate are positive to starboard, rudder angle to port, drift angle when the bow points to starboard of the course.'),
    el('p', {}, `Made by swayaw ${report.version || ''}. Plots by Plotly.js, MIT licence; the camera saves them as SVG.`));
}

function showLoop(report) {
  document.getElementById('report').append(...[
    el('div', { class: 'block' }, el('h3', {}, 'Steering indices, dimensionless'), indexTable(report.indices)),
    el('div', { class: 'plots block' },
      titledBox('Zigzag', plotBox('time', 'Zigzag', (node) => drawZigzag(report, node))),
      titledBox('Drift angle and yaw rate', plotBox('phase', 'Loop', (node) => drawLoop(report, node)))),
    el('div', { class: 'block' }, el('h3', {}, 'Measures and their derivatives'), measureTable(report)),
    report.map ? mapBlock(report) : null,
    footer(report),
  ].filter(Boolean));
  renderWhenNear();
}

showAfterPaint(showLoop);
