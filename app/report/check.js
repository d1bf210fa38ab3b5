// The page of a check: what was told of instruments, all runs side by side, and what the samples are like.

const INSTRUMENTS = {
  x: 'Positions', y: 'Positions, y', psi: 'Heading', r: 'Yaw rate', u: 'Speed through the water', v: 'Sway',
  ug: 'Speed over ground', vg: 'Sway over ground', stw: 'Log', delta: 'Rudder', delta_order: 'Rudder order', rev: 'Shaft speed',
};

const ERRORS = {
  zero: 'zero', scale: 'scale', delay: 'late', smoothing: 'smoothed over', axes: 'axes turned', clock: 'clock wanders',
  clock_rate: 'clock runs slow', jump: 'clock jumps, late by', lever_arm_x: 'point forward of midship', lever_arm_y: 'point to starboard',
};

const UNITS = {
  rad: { unit: 'deg', scale: DEGREES }, 'rad/s': { unit: 'deg/s', scale: DEGREES }, '': { unit: '%', scale: 100 },
};

const titleOf = (e) => `${INSTRUMENTS[e.channel] || e.channel}: ${ERRORS[e.error] || e.error}`;
const isMistake = (e) => ['sign', 'unit', 'order'].includes(e.error);
const shownIn = (e) => UNITS[e.unit] || { unit: e.unit, scale: 1 };

// ---- what was told -----------------------------------------------------------------------

function toldList(errors) {
  const told = errors.filter((e) => e.told);
  if (!told.length) return el('p', {}, 'No error of an instrument is told.');
  return el('ul', {}, ...told.map((e) => el('li', {}, e.words, e.remedy ? el('div', {}, small(`→ ${e.remedy}`)) : null)));
}

function sampleRow(c) {
  return row(
    el('th', { scope: 'row' }, INSTRUMENTS[c.channel] || c.channel),
    el('td', {}, String(c.samples)),
    el('td', {}, digits(c.noise)),
    el('td', {}, c.step > 0 ? digits(c.step) : MISSING),
    el('td', {}, c.interpolated ? `every ${digits(c.interval_s)} s, straight lines between` : 'each sample'),
    el('td', {}, c.outliers ? String(c.outliers) : MISSING));
}

function runBlock(run) {
  return el('section', { class: 'run' },
    el('h2', {}, run.run),
    toldList(run.instruments),
    ...run.derived.map((d) => el('p', { class: 'note' }, 
      `Not measured: ${INSTRUMENTS[d.channel] || d.channel} is made of ${d.made_of}; it is left out of the check.`)),
    ...run.cannot_tell.map((line) => el('p', { class: 'note' }, `Cannot tell: ${line}.`)),
    ...run.gaps_s.map(([from, to]) => el('p', { class: 'note' }, `No heading from ${between(from, to)}.`)),
    table('numbers',
      ['Channel', 'Samples', 'White noise, SI', 'Rounded to, SI', 'Measured', 'Outliers'].map((name) => column(name)),
      run.channels.map(sampleRow)));
}

// ---- all runs side by side ---------------------------------------------------------------

// Height of a plot beside its rows, and of a row, px.
const BESIDE_ROWS = 95;
const ROW = 26;

// Errors of one kind and channel, each with its run.
function groups(runs) {
  const found = new Map();
  for (const run of runs) {
    for (const e of run.instruments.filter((error) => !isMistake(error) && error.standard_error > 0)) {
      const key = `${e.channel} ${e.error}`;
      if (!found.has(key)) found.set(key, []);
      found.get(key).push({ ...e, run: run.run });
    }
  }
  return [...found.values()];
}

function drawGroup(group, pooledError, node) {
  const { unit, scale } = shownIn(group[0]);
  const names = group.map((e) => e.run);  // a text of Plotly may hold elements, which a name does not
  const shapes = pooledError ? [{
    type: 'rect', xref: 'x', yref: 'paper', y0: 0, y1: 1, line: { width: 0 }, fillcolor: WORST_FILL, layer: 'below',
    x0: scale * (pooledError.value - 1.96 * pooledError.standard_error),
    x1: scale * (pooledError.value + 1.96 * pooledError.standard_error),
  }] : [];
  plot(node, [{
    type: 'scatter', mode: 'markers', x: group.map((e) => scale * e.value), y: names.map(plotText), customdata: names,
    error_x: { type: 'data', array: group.map((e) => 1.96 * scale * e.standard_error), thickness: 1.4, width: 3, color: '#5a6470' },
    marker: { size: 8, color: group.map((e) => (e.told ? '#e07b00' : '#0072b2')) },
    hovertemplate: `%{y}<br>%{x:.3~g} ${unit}<extra></extra>`,
  }], {
    shapes,
    margin: { ...MARGIN, t: 34, l: 20 },
    xaxis: axis(unit, { zeroline: true, zerolinewidth: 2 }),
    yaxis: { automargin: true, type: 'category', autorange: 'reversed' },
  });
}

function groupBox(group, all) {
  const pooledError = (all || []).find((e) => e.channel === group[0].channel && e.error === group[0].error);
  const box = plotBox('bars', titleOf(group[0]), (node) => drawGroup(group, pooledError, node), 'runs');
  box.style.height = `${BESIDE_ROWS + ROW * group.length}px`;
  return el('div', {}, el('h3', {}, titleOf(group[0])), box,
    pooledError ? el('p', { class: 'note' }, `All runs: ${pooledError.words}`) : null);
}

// ---- the page ----------------------------------------------------------------------------

function footer(report) {
  return el('footer', {},
    el('p', {}, el('strong', {}, 'How. '),
      'ẋ = u cos ψ − v sin ψ, ẏ = u sin ψ + v cos ψ and ψ̇ = r hold for every ship; what breaks them is an instrument, a ' +
      'clock or the file. An error is told when it lies beyond 3.7 standard errors and is large enough to matter. Bars: ' +
      '95 % intervals. Violet: all runs together.'),
    el('p', {}, `Made by swayaw ${report.version || ''}. Plots by Plotly.js, MIT licence; the camera saves them as SVG.`));
}

function showCheck(report) {
  document.getElementById('report').append(
    el('div', { class: 'runs runs-2 block' }, ...groups(report.runs).map((group) => groupBox(group, report.all_runs))),
    ...report.runs.map(runBlock),
    footer(report));
  renderWhenNear();
}

showAfterPaint(showCheck);
