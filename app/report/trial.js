// The page of recorded manoeuvres for the owner: verdict, a table of numbers, heading and rudder, the track.

const RECORDED = '#2b2b2b';
const CORRECTED = '#e07b00';
const SIMULATED = '#0072b2';
const RUDDER = '#8b949e';
const PLACE = 'north %{y:.4~g} m, east %{x:.4~g} m<br>at %{customdata:.1f} s';

const capital = (words) => words.charAt(0).toUpperCase() + words.slice(1);

// To the second digit of the standard error, but no more than five digits of the value.
function told(number) {
  if (!number || !isNumber(number.value)) return [MISSING];
  const { value, standard_error: error } = number;
  if (!isNumber(error)) return [trimmed(value)];
  const places = (x, count) => count - 1 - Math.floor(Math.log10(Math.abs(x)));
  const most = value === 0 ? 4 : places(value, 5);
  const decimals = Math.min(Math.max(error > 0 ? Math.min(places(error, 2), most) : most, 0), 8);
  const shown = error > 0 ? Math.max(error, 10 ** -decimals) : 0;
  return [plain(value.toFixed(decimals)), ' ', small(`± ${shown.toFixed(decimals)}`)];
}

// ---- tables ------------------------------------------------------------------------------

function numbersTable(run) {
  const some = (key) => run.rows.some((line) => line[key] !== null);
  const [corrected, simulated, lengths] = ['corrected', 'simulated', 'in_lengths'].map(some);
  const headings = [column('Number'), column(corrected ? 'As recorded' : 'Recorded'),
    ...(corrected ? [column('Drift taken off')] : []), ...(simulated ? [column('Simulated')] : []), column('Unit'),
    ...(lengths ? [column('In ship lengths')] : [])];
  const rows = run.rows.map((line) => row(
    el('th', { scope: 'row' }, capital(line.name)),
    el('td', {}, ...told(line.recorded)),
    ...(corrected ? [el('td', {}, ...(line.corrected ? told(line.corrected) : ['']))] : []),
    ...(simulated ? [el('td', {}, isNumber(line.simulated) ? digits(line.simulated) : '')] : []),
    el('td', {}, line.unit),
    ...(lengths ? [el('td', {}, isNumber(line.in_lengths) ? plain(line.in_lengths.toFixed(3)) : '')] : [])));
  return table('numbers', headings, rows);
}

// ---- plots -------------------------------------------------------------------------------

function line(name, color, x, y, more = {}) {
  return { type: 'scatter', mode: 'lines', name, x, y, line: { color, width: 1.9 }, hovertemplate: '%{y:.4~g}', ...more };
}

// The heading off the approach and the rudder, over time; the first-order fit and the simulation beside the heading.
function drawTime(run, node) {
  const { plots } = run;
  const traces = [
    line('rudder, to port', RUDDER, plots.time_s, plots.rudder_deg, { line: { color: RUDDER, width: 1.4 } }),
    line('heading', RECORDED, plots.time_s, plots.heading_deg)];
  if (plots.fit_time_s) {
    traces.push(line('K and T', CORRECTED, plots.fit_time_s, plots.fit_heading_deg,
      { line: { color: CORRECTED, width: 1.7, dash: '6px,3px' } }));
  }
  if (plots.simulated) {
    traces.push(line('simulated', SIMULATED, plots.simulated.time_s, plots.simulated.heading_deg,
      { line: { color: SIMULATED, width: 1.7, dash: '2px,3px' } }));
  }
  const peaks = (run.peak_s || []).map((peak) => (peak ? peak.value : null));
  const executes = Array.isArray(run.execute_s) ? run.execute_s : [run.execute_s];
  const mark = (color) => (time) => ({
    type: 'line', xref: 'x', yref: 'paper', x0: time, x1: time, y0: 0, y1: 1, layer: 'below', line: { color, width: 1 } });
  plot(node, traces, {
    margin: MARGIN, hovermode: 'x unified', showlegend: true, legend: { orientation: 'h', y: 1.09, x: 0 },
    xaxis: axis('Time, s', { hoverformat: '.1f' }), yaxis: axis('Heading off the approach and rudder, deg'),
    shapes: [...executes.filter(Boolean).map(({ value }) => mark('#d5dae0')(value)), ...peaks.filter(isNumber).map(mark('#f0bd80'))],
  });
}

function drawTrack(run, node) {
  const { plots } = run;
  const traces = [line('as recorded', RECORDED, plots.y_m, plots.x_m, { customdata: plots.time_s, hovertemplate: PLACE })];
  if (plots.x_corrected_m) traces.push(line('drift taken off', CORRECTED, plots.y_corrected_m, plots.x_corrected_m, { customdata: plots.time_s, hovertemplate: PLACE }));
  if (plots.simulated) {
    const start = plots.time_s.findIndex((time) => isNumber(time) && time >= run.execute);
    const [north, east, heading] = [plots.x_m[start], plots.y_m[start], run.approach_heading_rad.value];
    const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
    const { x_m: ahead, y_m: starboard } = plots.simulated;
    traces.push(line('simulated', SIMULATED, ahead.map((x, i) => east + x * sin + starboard[i] * cos),
      ahead.map((x, i) => north + x * cos - starboard[i] * sin), { customdata: plots.simulated.time_s, hovertemplate: PLACE, line: { color: SIMULATED, width: 1.7, dash: '2px,3px' } }));
  }
  plot(node, traces, {
    margin: MARGIN, showlegend: true, legend: { orientation: 'h', y: 1.09, x: 0 },
    xaxis: axis('East, m'), yaxis: axis('North, m', { scaleanchor: 'x', scaleratio: 1 }),
  });
}

function drawSpiral(run, node) {
  const port = run.steps.map((step) => step.delta_rad * DEGREES);
  plot(node, [line('', RECORDED, port, run.steps.map((step) => step.yaw_rate_rad_s.value * DEGREES), { mode: 'lines+markers' })],
    { margin: MARGIN, xaxis: axis('Rudder, deg to port'), yaxis: axis('Yaw rate, deg/s to starboard') });
}

function plotsOf(run) {
  const boxes = [plotBox('time', `Heading and rudder of ${run.run}`, (node) => drawTime(run, node), run.run)];
  if (run.steps) boxes.push(plotBox('track', `Spiral of ${run.run}`, (node) => drawSpiral(run, node)));
  else if (has(run.plots.x_m)) boxes.push(plotBox('track', `Track of ${run.run}`, (node) => drawTrack(run, node), run.run));
  return el('div', { class: boxes.length > 1 ? 'plots' : 'plots single' }, ...boxes);
}

// ---- page --------------------------------------------------------------------------------

function runSection(run) {
  const speed = run.approach_speed_m_s ? ['approach ', ...told(run.approach_speed_m_s), ` m/s ${run.approach_speed_source}`] : [];
  return el('section', { class: 'run' },
    el('h2', {}, `${run.run}: ${run.manoeuvre}${run.first ? ` to ${run.first}` : ''}`),
    el('p', { class: 'facts', style: 'margin-bottom: 1.8rem' }, ...speed),
    plotsOf(run),
    el('div', { class: 'block' }, numbersTable(run)),
    ...run.notes.map((note) => el('p', { class: 'note' }, `${capital(note)}.`)));
}

function showTrial(report) {
  const length = isNumber(report.length_m) ? `Length ${trimmed(report.length_m)} m. ` : '';
  document.getElementById('report').append(
    ...report.runs.map(runSection),
    el('footer', {},
      el('p', {}, `${length}± is one standard error of instrument noise, rounding and sampling; wind, waves and the helmsman are not in it. ` +
        'A criterion cannot be told where its limit lies within two standard errors of the value.'),
      el('p', {}, 'K is positive where a rudder to starboard turns the ship to starboard. Rudder angles in the plots are positive to port.'),
      el('p', {}, `Made by swayaw ${report.version || ''}. Plots by Plotly.js, MIT licence.`)));
  renderWhenNear();
}

function prepared(report) {
  return { ...report, runs: (report.runs || []).map((run) => ({ notes: [], rows: [], plots: {}, ...run })) };
}

showAfterPaint((report) => showTrial(prepared(report)));
