// What every report page uses.

const DEGREES = 180 / Math.PI;
const MISSING = '–';

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

function table(className, headings, rows) {
  return el('div', { class: 'scroll' },
    el('table', { class: className },
      el('thead', {}, row(...headings)),
      el('tbody', {}, ...rows)));
}

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

// ---- plots -------------------------------------------------------------------------------

const pending = new Map();

function render(node) {
  const draw = pending.get(node);
  if (!draw) return;
  pending.delete(node);
  draw(node);
}

function plotBox(className, label, draw) {
  const node = el('div', { class: `plot ${className}`, role: 'img', 'aria-label': label });
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
  Plotly.newPlot(node, traces, { ...shared, ...layout }, config);
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

// ---- printing ----------------------------------------------------------------------------

const renderAll = () => [...pending.keys()].forEach(render);

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
