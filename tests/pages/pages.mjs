// The pages in a browser: what users ask is answered on the first screen, without scripts, on a wide screen, on a phone
// and in print; nothing fails in the console; nobody is kept out (axe-core).
//
//   node pages.mjs PROGRAM PROJECT FOLDER [SHOTS]      77: there is no Chromium
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium, HEADLESS, tab, valueOf } from './browser.mjs';
import { fetched } from './npm.mjs';
import { pagesOf, threeRuns } from './three_runs.mjs';

const [program, project, folder, shots] = process.argv.slice(2);
const recordings = ['weak_rudder_zz10_10.csv', 'weak_rudder_turn35.csv'].map((run) => join(project, 'examples/recordings', run));
const ship = (name) => join(project, 'ships', `${name}.toml`);
const indices = join(project, 'examples/indices/nawigator.toml');

// What users ask, and the page that answers it: the question as it stands there.
const PAGES = [
  { name: 'indices', words: ['indices', ship('tanker97')], asked: ['Is she stable on course?'] },
  { name: 'imo', words: ['simulate', ship('kvlcc2'), '--imo'], asked: ['Does she pass?'] },
  { name: 'trial', words: ['trial', ...recordings, '--ship', ship('kvlcc2_l7')], asked: ['Does she pass?'] },
  { name: 'compare', words: ['compare', ship('kvlcc2_l7'), ...recordings], asked: ['How far off is the model?', 'Where is it worst?'] },
  {
    name: 'diagnose',
    words: ['diagnose', ship('kvlcc2_l7'), ...recordings],
    asked: ['How far off is my model?', 'What is wrong with it?', 'Whose fault is it?', 'How sure is it?', 'What should I sail next?'],
  },
  { name: 'check', words: ['check', ...recordings], asked: ['Can the recordings be believed?'] },
  {
    name: 'identify',
    words: ['identify', recordings[0], '--ship', ship('kvlcc2_l7'), '--model', 'mmg', '--find', 'Y_v,N_v,N_r', '--holdout', recordings[1],
      '--out', join(folder, 'identified.toml')],
    asked: ['Which coefficients can I trust?'],
  },
  {
    name: 'tune',
    words: ['tune', ship('nawigator_ym'), '--indices', indices, '--prior', '1', '--bound', '1', '--turns', '40', '--out', join(folder, 'tuned.toml')],
    asked: ['Does she turn as measured now?'],
  },
  { name: 'loop', words: ['loop', ship('tanker97'), '--zigzag', '10/10'], asked: [] },
];

const SCREENS = [
  { name: 'wide', size: [1400, 900], height: 900 },
  { name: 'phone', size: [500, 900], height: 900, width: 400 },  // headless Chromium has no narrower window than 500
  { name: 'print', size: [794, 1123], height: 1123, style: (html) => html.replaceAll('@media print', '@media all') },
];
const MOST_BYTES = 2.5e6;

let failures = 0;
function check(holds, sentence) {
  if (holds) return;
  failures += 1;
  console.error(`not true: ${sentence}`);
}

const browser = chromium();
if (!browser) {
  console.log('[skipped] the pages are not looked at: there is no Chromium');
  process.exit(77);
}

function browse(file, size, more) {
  const run = spawnSync(browser, [...HEADLESS, '--enable-logging=stderr', `--window-size=${size}`,
    '--virtual-time-budget=20000', ...more, `file://${file}`], { encoding: 'utf8', maxBuffer: 1 << 28 });
  return { out: run.stdout, complaints: run.stderr.split('\n').filter((line) => /CONSOLE/.test(line) && /error|uncaught|refused/i.test(line)) };
}

// The text of axe-core; null where it could not be fetched.
function axe() {
  const file = fetched('axe-core/axe.min.js', folder);
  if (file) return readFileSync(file, 'utf8');
  console.log('[skipped] accessibility is not tested: axe-core could not be fetched');
  return null;
}

const withoutScripts = (html) => html.replace(/<script[\s\S]*?<\/script>/g, '');

// A page with a script of ours at its end, which leaves what it finds in an element. As it is, a page runs no script but its own.
function asked(page, script) {
  const html = page.replace(/script-src [^;]*/, "script-src 'unsafe-inline'");
  return `${html}<pre id="found" hidden></pre><script>addEventListener('load', async () => {
    const found = await (${script})();
    document.getElementById('found').textContent = btoa(unescape(encodeURIComponent(JSON.stringify(found))));
  });</script>`;
}

function found(dom) {
  const text = /<pre id="found" hidden="">([^<]*)<\/pre>/.exec(dom);
  return text && text[1] ? JSON.parse(Buffer.from(text[1], 'base64').toString('utf8')) : null;
}

const measure = `async () => ({
  width: document.documentElement.scrollWidth, body: document.body.scrollWidth, inner: innerWidth,
  headline: document.querySelector('.verdict').getBoundingClientRect().bottom,
  answers: [...document.querySelectorAll('.answers > div')].map((div) => ({
    asked: div.querySelector('dt').textContent, said: div.querySelector('dd').textContent, bottom: div.getBoundingClientRect().bottom })),
  pictures: [...document.querySelectorAll('.first img')].map((img) => ({ width: img.naturalWidth, words: img.alt })),
})`;

function look(page, html, screen) {
  const file = join(folder, `${page.name}_${screen.name}.html`);
  const shown = screen.style ? screen.style(html) : html;
  const narrow = screen.width ? `<style>body { width: ${screen.width}px; }</style>` : '';
  writeFileSync(file, asked(withoutScripts(phoneStyle(shown, screen)) + narrow, measure));
  const seen = found(browse(file, screen.size, ['--dump-dom']).out);
  const where = `${page.name}, ${screen.name}`;
  check(seen !== null, `${where}: the page is drawn`);
  if (!seen) return;
  check(seen.width <= (screen.width ? screen.size[0] : seen.inner) + 1 && seen.body <= (screen.width || seen.inner) + 1, `${where}: nothing is wider than the screen (${seen.width}, ${seen.body} px)`);
  check(seen.headline <= screen.height, `${where}: the headline is on the first screen`);
  for (const question of page.asked) {
    const answer = seen.answers.find((one) => one.asked === question);
    check(answer !== undefined && answer.said.length > 3, `${where}: "${question}" is answered`);
    if (answer) check(answer.bottom <= screen.height, `${where}: "${question}" is answered on the first screen (${Math.round(answer.bottom)} px)`);
  }
  for (const picture of seen.pictures) check(picture.width > 0 && picture.words.length > 20, `${where}: the picture is there, and in words`);
}

// The rules for narrow screens hold in a frame of the phone's width whatever the window.
const phoneStyle = (html, screen) => (screen.name === 'phone' ? html.replace(/@media \(max-width: (860|640)px\)/g, '@media all') : html);

// What axe-core finds, and the plots that are not drawn when the page is printed.
const trial = (withAxe) => `async () => {
  await new Promise((then) => setTimeout(then, 1500));
  const found = ${withAxe ? 'await axe.run()' : '{ violations: [] }'};
  dispatchEvent(new Event('beforeprint'));
  return {
    barriers: found.violations.filter(({ impact }) => ['serious', 'critical'].includes(impact))
      .map(({ id, nodes }) => id + ': ' + nodes.slice(0, 2).map(({ html }) => html.slice(0, 120)).join(' and ')),
    drawn: document.querySelectorAll('.js-plotly-plot').length,
    missing: [...document.querySelectorAll('.plot:not(.js-plotly-plot)')].map((plot) => plot.getAttribute('aria-label')),
  };
}`;

function tryAll(page, html, helper) {
  const file = join(folder, `${page.name}_whole.html`), script = trial(helper !== null);
  writeFileSync(file, asked(helper === null ? html : `${html}<script>${helper}</script>`, script));
  const { out, complaints } = browse(file, [1400, 900], ['--dump-dom']);
  check(complaints.length === 0, `${page.name}: the console is silent: ${complaints.join(' ')}`);
  const seen = found(out);
  check(seen !== null, `${page.name}: its scripts end`);
  for (const barrier of seen ? seen.barriers : []) check(false, `${page.name}: nobody is kept out: ${barrier}`);
  if (html.includes('id="data"')) check(seen && seen.drawn > 0, `${page.name}: there are plots`);
  for (const plot of seen ? seen.missing : []) check(false, `${page.name}: ${plot} is drawn for print`);
}

// What is hovered in one plot is marked in the others of the same run, and in no other. In a check it is a run, which need not have every
// error of an instrument.
async function lookAtCursor(page, file) {
  const browser = await tab();
  await browser.ask('Page.enable');
  await browser.ask('Page.navigate', { url: `file://${file}` });
  const at = await valueOf(browser, `new Promise((then) => {
    const look = () => {
      const [plot] = document.querySelectorAll('.plot[data-cursor]');
      if (!plot) return setTimeout(look, 50);
      dispatchEvent(new Event('beforeprint'));
      dispatchEvent(new Event('afterprint'));
      plot.scrollIntoView({ block: 'start' });
      setTimeout(() => {
        const { x, y, width, height } = plot.getBoundingClientRect(), curve = plot.querySelector('.point, .js-line').getBoundingClientRect();
        then(plot.classList.contains('bars') ? { x: curve.x + curve.width / 2, y: curve.y + curve.height / 2 } : { x: x + width / 2, y: y + height / 6 });
      }, 1000);
    };
    look();
  })`);
  for (const step of [0, 1]) await browser.ask('Input.dispatchMouseEvent', { type: 'mouseMoved', x: at.x + step, y: at.y });
  const marks = await valueOf(browser, `new Promise((then) => setTimeout(() => then([...document.querySelectorAll('.plot[data-cursor]')].map((plot) => ({
    cursor: plot.dataset.cursor, label: plot.getAttribute('aria-label'), marked: plot.querySelectorAll('.hoverlayer .hovertext, .hoverlayer .legend').length > 0 }))), 500))`);
  browser.close();
  const [first, ...others] = marks;
  check(others.some(({ cursor, marked }) => marked && cursor === first.cursor), `${page.name}: hovering "${first.label}" marks other plots`);
  for (const { cursor, label, marked } of others) {
    const must = cursor === first.cursor;
    if (cursor !== 'runs') check(marked === must, `${page.name}: hovering "${first.label}" marks ${must ? '' : 'nothing in '}"${label}" of ${cursor}`);
  }
}

// The data of a page are what its script reads: keys of the whole and of each run.
function lookAtData(page, html) {
  const [, text] = /<script id="data"[^>]*>(.*?)<\/script>/s.exec(html) || [];
  if (!text) return;
  const data = JSON.parse(text), script = html.slice(html.lastIndexOf('<script>'));
  for (const key of new Set([data, ...(data.runs || [])].flatMap(Object.keys)))
    check(new RegExp(`\\b${key}\\b`).test(script), `${page.name}: the script reads ${key} of the data`);
}

for (const place of [folder, shots].filter(Boolean)) mkdirSync(place, { recursive: true });
const helper = axe();
for (const page of PAGES) {
  const file = join(folder, `${page.name}.html`);
  rmSync(file, { force: true });
  execFileSync(program, [...page.words, '--report', file], { stdio: ['ignore', 'ignore', 'ignore'] });
  check(statSync(file).size < MOST_BYTES, `${page.name}: less than ${MOST_BYTES} bytes`);
  const html = readFileSync(file, 'utf8');
  for (const screen of SCREENS) look(page, html, screen);
  lookAtData(page, html);
  tryAll(page, html, helper);
  if (shots) browse(file, [1400, 900], [`--screenshot=${join(shots, `${page.name}.png`)}`]);
}
for (const page of pagesOf(threeRuns(program, project, folder))) {
  const file = join(folder, `${page.name}_three_runs.html`);
  execFileSync(program, [...page.words, '--report', file], { stdio: 'ignore' });
  check(statSync(file).size < MOST_BYTES, `${page.name}: three runs of a thousand samples take less than ${MOST_BYTES} bytes`);
  tryAll({ name: `${page.name} of three runs` }, readFileSync(file, 'utf8'), helper);
  await lookAtCursor(page, file);
  // the wind came from 1 rad
  if (page.name === 'diagnose')
    check(/<img alt="A rose, north up. Wind from 057 ± \d+ deg \(ENE\); headings sailed: all/.test(readFileSync(file, 'utf8')), 'diagnose: a rose shows where the wind came from');
}
console.log(failures ? `${failures} failures` : `${PAGES.length} pages looked at`);
process.exit(failures ? 1 : 0);
