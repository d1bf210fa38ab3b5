// What every report page uses.

const DEGREES = 180 / Math.PI;
const MISSING = '–';
const WORST_FILL = '#e6def2';
const MARGIN = { l: 58, r: 10, t: 26, b: 42 };

// ---- words and numbers -------------------------------------------------------------------

const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);
const plain = (number) => String(number).replace('-', '−');

// Three significant digits for tables: 16.0, 0.0123.
function digits(value) {
  if (!isNumber(value)) return MISSING;
  const text = value.toPrecision(3);
  return plain(text.includes('e') ? Number(text) : text);
}

// The same number without closing zeros, for running text and axis labels.
const trimmed = (value) => plain(Number(value.toPrecision(4)));

function seconds(value) {
  return isNumber(value) ? plain(Math.round(value * 10) / 10) : MISSING;
}

function percent(fraction) {
  if (!isNumber(fraction)) return MISSING;
  const value = 100 * fraction;
  return `${plain(value.toFixed(Math.abs(value) < 9.95 ? 1 : 0))}\u00a0%`;
}

function counted(count, noun) {
  return `${count} ${noun}${count === 1 ? '' : 's'}`;
}

function between(from, to) {
  return `${seconds(from)} to ${seconds(to)} s`;
}

// ---- elements ----------------------------------------------------------------------------

function el(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children.filter((child) => child !== null));
  return node;
}

const row = (...cells) => el('tr', {}, ...cells);
const column = (...words) => el('th', { scope: 'col' }, ...words);
const small = (words) => el('small', {}, words);

// What may be wider than the screen; the keyboard moves it, too.
const scrolled = (node) => el('div', { class: 'scroll', tabindex: '0' }, node);

function table(className, headings, rows) {
  return scrolled(el('table', { class: className }, el('thead', {}, row(...headings)), el('tbody', {}, ...rows)));
}

// White at nothing, deep orange from 40 %.
function shade(fraction) {
  if (!isNumber(fraction)) return 'transparent';
  return `rgba(224, 123, 0, ${(0.75 * Math.min(Math.abs(fraction) / 0.4, 1)).toFixed(3)})`;
}

function shaded(fraction, content = percent(fraction)) {
  return el('td', { style: `background:${shade(fraction)}` }, content);
}

// Plotly takes some elements of HTML in a text for its looks, links among them; in a name they are what they look like.
const plotText = (words) => words.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

// ---- channels ----------------------------------------------------------------------------

const has = (values) => Array.isArray(values) && values.some(isNumber);

// Applies a formula sample by sample; missing where any of its inputs is.
function combine(formula, ...channels) {
  if (!channels.every(has)) return null;
  return channels[0].map((_, i) => {
    const values = channels.map((channel) => channel[i]);
    return values.every(isNumber) ? formula(...values) : null;
  });
}

const inDegrees = (channel) => combine((angle) => angle * DEGREES, channel);

// ---- opening -----------------------------------------------------------------------------

// The first screen is painted before the data are read and anything is drawn.
function showAfterPaint(show) {
  const data = () => JSON.parse(document.getElementById('data').textContent);
  requestAnimationFrame(() => setTimeout(() => show(data())));
}

// The library is a text of the page until the first plot comes near.
function loadPlotly() {
  const script = document.createElement('script');
  script.textContent = document.getElementById('plotly').textContent;
  document.head.append(script);
}

// ---- plots -------------------------------------------------------------------------------

const pending = new Map();

function render(node) {
  const draw = pending.get(node);
  if (!draw) return;
  pending.delete(node);
  draw(node);
}

// Plots of one cursor mark what is hovered in any of them.
function plotBox(className, label, draw, cursor = null) {
  const node = el('div', { class: `plot ${className}`, role: 'img', 'aria-label': label });
  if (cursor !== null) node.dataset.cursor = cursor;
  pending.set(node, draw);
  return node;
}

function plot(node, traces, layout, options = {}) {
  const touch = window.matchMedia('(pointer: coarse)').matches;
  const shared = {
    font: { family: getComputedStyle(document.body).fontFamily, size: 12, color: '#1b1f24' },
    paper_bgcolor: '#fff',
    plot_bgcolor: '#fff',
    showlegend: false,
    dragmode: touch ? false : 'zoom',
    hoverlabel: { bgcolor: '#fff', font: { color: '#1b1f24' } },
  };
  const config = {
    displaylogo: false,
    responsive: true,
    showSendToCloud: false,
    plotlyServerURL: '',
    modeBarButtonsToRemove: ['select2d', 'lasso2d', 'autoScale2d'],
    toImageButtonOptions: { format: 'svg' },
    ...options,
  };
  if (!window.Plotly) loadPlotly();
  Plotly.newPlot(node, traces, { ...shared, ...layout }, config);
  if (node.dataset.cursor !== undefined) shareCursor(node);
}

// ---- one cursor for the plots of a run ---------------------------------------------------

// What a point stands for, the time or the run: its custom data, else its abscissa.
const markOf = ({ customdata, x }) => (customdata === undefined ? x : customdata);

// The point of a curve that stands for it, or that is nearest in time; -1: none.
function pointFor(mark, { customdata }) {
  if (!isNumber(mark)) return customdata.indexOf(mark);
  const distance = (i) => Math.abs(customdata[i] - mark);
  return customdata.reduce((best, _, i) => (distance(i) < distance(best) ? i : best), 0);
}

function showMark(node, mark) {
  const curveNumber = node.data.findIndex(({ customdata, visible }) => customdata && visible !== false);
  if (curveNumber < 0) return Plotly.Fx.hover(node, { xval: mark }, 'xy', true);
  const pointNumber = pointFor(mark, node.data[curveNumber]);
  return pointNumber < 0 ? null : Plotly.Fx.hover(node, [{ curveNumber, pointNumber }], undefined, true);
}

function shareCursor(node) {
  const others = () => [...document.querySelectorAll('.js-plotly-plot')]
    .filter((other) => other !== node && other.dataset.cursor === node.dataset.cursor);
  node.on('plotly_hover', ({ points: [point] }) => others().forEach((other) => showMark(other, markOf(point))));
  node.on('plotly_unhover', () => others().forEach((other) => Plotly.Fx.unhover(other)));
}

function axis(title, more = {}) {
  return {
    title: { text: title, standoff: 6, font: { size: 12 } },
    gridcolor: '#e8ebee',
    zerolinecolor: '#b9c0c8',
    linecolor: '#8b949e',
    showline: true,
    ticks: 'outside',
    ticklen: 3,
    tickcolor: '#8b949e',
    ...more,
  };
}

function panelAxes(panels) {
  const gap = 0.022;
  const height = (1 - gap * (panels.length - 1)) / panels.length;
  const axes = {};
  panels.forEach((panel, index) => {
    const top = 1 - index * (height + gap);
    axes[`yaxis${index + 1}`] = axis(panel.title, { domain: [Math.max(top - height, 0), top], nticks: 6 });
  });
  return axes;
}

// ---- ships ------------------------------------------------------------------------------

// The hull seen from above, as [forward, starboard] in ship lengths.
const HULL = [
  [0.5, 0], [0.32, 0.085], [-0.46, 0.085], [-0.5, 0.06],
  [-0.5, -0.06], [-0.46, -0.085], [0.32, -0.085], [0.5, 0],
];

function hullAt(north, east, heading, length) {
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return HULL.map(([ahead, starboard]) => [
    north + length * (ahead * cos - starboard * sin),
    east + length * (ahead * sin + starboard * cos),
  ]);
}

// Samples a fixed distance apart along the track, where a hull is drawn.
function stations(part, length) {
  const complete = part.x_m.map((_, i) => i)
    .filter((i) => [part.x_m, part.y_m, part.psi_rad].every((channel) => isNumber(channel[i])));
  const steps = complete.map((i, k) => (k === 0 ? 0
    : Math.hypot(part.x_m[i] - part.x_m[complete[k - 1]], part.y_m[i] - part.y_m[complete[k - 1]])));
  const spacing = Math.max(2 * length, steps.reduce((sum, step) => sum + step, 0) / 14);
  let travelled = spacing;
  return complete.filter((_, k) => {
    travelled += steps[k];
    if (travelled < spacing) return false;
    travelled = 0;
    return true;
  });
}

// ---- when plots are drawn ----------------------------------------------------------------

const renderAll = () => [...pending.keys()].forEach(render);

function renderWhenNear() {
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries.filter(({ isIntersecting }) => isIntersecting)) {
      seen.unobserve(entry.target);
      render(entry.target);
    }
  }, { rootMargin: '800px' });
  for (const node of pending.keys()) seen.observe(node);
}

function fitToBoxes() {
  for (const node of document.querySelectorAll('.js-plotly-plot')) {
    Plotly.relayout(node, { autosize: true });
  }
}

function setPrinting(printing) {
  document.documentElement.classList.toggle('printing', printing);
  if (printing) renderAll();
  fitToBoxes();
}

window.addEventListener('beforeprint', () => setPrinting(true));
window.addEventListener('afterprint', () => setPrinting(false));
