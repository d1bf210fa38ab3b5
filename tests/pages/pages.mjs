// The pages in a browser: what users ask is answered on the first screen, without scripts, on a wide screen, on a phone
// and in print; nothing fails in the console; nobody is kept out (axe-core).
//
//   node pages.mjs PROGRAM PROJECT FOLDER [SHOTS]      77: there is no Chromium
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium, open, tab, valueOf } from './browser.mjs';
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
  { name: 'wide', width: 1400, height: 900 },
  { name: 'phone', width: 400, height: 900 },
  { name: 'print', width: 794, height: 1123, media: 'print' },
];
const MOST_BYTES = 2.5e6;

let failures = 0;
function check(holds, sentence) {
  if (holds) return;
  failures += 1;
  console.error(`not true: ${sentence}`);
}

if (!chromium()) {
  console.log('[skipped] the pages are not looked at: there is no Chromium');
  process.exit(77);
}

// The text of axe-core; null where it could not be fetched.
function axe() {
  const file = fetched('axe-core/axe.min.js', folder);
  if (file) return readFileSync(file, 'utf8');
  console.log('[skipped] accessibility is not tested: axe-core could not be fetched');
  return null;
}

const measure = `({
  width: document.documentElement.scrollWidth, body: document.body.scrollWidth, inner: innerWidth,
  headline: document.querySelector('.verdict').getBoundingClientRect().bottom,
  answers: [...document.querySelectorAll('.answers > div')].map((div) => ({
    asked: div.querySelector('dt').textContent, said: div.querySelector('dd').textContent, bottom: div.getBoundingClientRect().bottom })),
  pictures: [...document.querySelectorAll('.first img')].map((img) => ({ width: img.naturalWidth, words: img.alt })),
})`;

const show = ({ width, height, media = '' }) => Promise.all([
  browser.ask('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false }),
  browser.ask('Emulation.setEmulatedMedia', { media })]);

async function look(page, file, screen) {
  await show(screen);
  await browser.ask('Emulation.setScriptExecutionDisabled', { value: true });
  await open(browser, file);
  const seen = await valueOf(browser, measure);
  await browser.ask('Emulation.setScriptExecutionDisabled', { value: false });
  const where = `${page.name}, ${screen.name}`;
  check(seen.inner === screen.width, `${where}: the screen is ${screen.width} px wide, not ${seen.inner}`);
  check(Math.max(seen.width, seen.body) <= seen.inner + 1, `${where}: nothing is wider than the screen (${seen.width}, ${seen.body} px)`);
  check(seen.headline <= screen.height, `${where}: the headline is on the first screen`);
  for (const question of page.asked) {
    const answer = seen.answers.find((one) => one.asked === question);
    check(answer !== undefined && answer.said.length > 3, `${where}: "${question}" is answered`);
    if (answer) check(answer.bottom <= screen.height, `${where}: "${question}" is answered on the first screen (${Math.round(answer.bottom)} px)`);
  }
  for (const picture of seen.pictures) check(picture.width > 0 && picture.words.length > 20, `${where}: the picture is there, and in words`);
}

// What axe-core finds, and the plots that are not drawn when the page is printed.
const trial = (withAxe) => `(async () => {
  await new Promise((then) => setTimeout(then, 300));
  const found = ${withAxe ? 'await axe.run()' : '{ violations: [] }'};
  dispatchEvent(new Event('beforeprint'));
  return {
    barriers: found.violations.filter(({ impact }) => ['serious', 'critical'].includes(impact))
      .map(({ id, nodes }) => id + ': ' + nodes.slice(0, 2).map(({ html }) => html.slice(0, 120)).join(' and ')),
    drawn: document.querySelectorAll('.js-plotly-plot').length,
    missing: [...document.querySelectorAll('.plot:not(.js-plotly-plot)')].map((plot) => plot.getAttribute('aria-label')),
  };
})()`;

async function tryAll(page, file, helper) {
  complaints.length = 0;
  await show(SCREENS[0]);
  await open(browser, file);
  if (helper !== null) await valueOf(browser, `${helper}; null`);
  const seen = await valueOf(browser, trial(helper !== null));
  check(complaints.length === 0, `${page.name}: the console is silent: ${complaints.join(' ')}`);
  for (const barrier of seen.barriers) check(false, `${page.name}: nobody is kept out: ${barrier}`);
  if (readFileSync(file, 'utf8').includes('id="data"')) check(seen.drawn > 0, `${page.name}: there are plots`);
  for (const plot of seen.missing) check(false, `${page.name}: ${plot} is drawn for print`);
}

// What is hovered in one plot is marked in the others of the same run, and in no other. In a check it is a run, which need not have every
// error of an instrument.
async function lookAtCursor(page, file) {
  await open(browser, file);
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
const helper = axe(), browser = await tab(), complaints = [];
for (const domain of ['Page', 'Runtime', 'Log']) await browser.ask(`${domain}.enable`);
browser.each('Log.entryAdded', ({ entry }) => entry.level === 'error' && complaints.push(entry.text));
browser.each('Runtime.exceptionThrown', ({ exceptionDetails }) => complaints.push(exceptionDetails.exception?.description ?? exceptionDetails.text));
browser.each('Runtime.consoleAPICalled', ({ type, args }) => type === 'error' && complaints.push(args.map(({ value }) => value).join(' ')));
for (const page of PAGES) {
  const file = join(folder, `${page.name}.html`);
  rmSync(file, { force: true });
  execFileSync(program, [...page.words, '--report', file], { stdio: ['ignore', 'ignore', 'ignore'] });
  check(statSync(file).size < MOST_BYTES, `${page.name}: less than ${MOST_BYTES} bytes`);
  const html = readFileSync(file, 'utf8');
  for (const screen of SCREENS) await look(page, file, screen);
  lookAtData(page, html);
  await tryAll(page, file, helper);
  if (!shots) continue;
  await open(browser, file);
  writeFileSync(join(shots, `${page.name}.png`), Buffer.from((await browser.ask('Page.captureScreenshot')).data, 'base64'));
}
for (const page of pagesOf(threeRuns(program, project, folder))) {
  const file = join(folder, `${page.name}_three_runs.html`);
  execFileSync(program, [...page.words, '--report', file], { stdio: 'ignore' });
  check(statSync(file).size < MOST_BYTES, `${page.name}: three runs of a thousand samples take less than ${MOST_BYTES} bytes`);
  await tryAll({ name: `${page.name} of three runs` }, file, helper);
  await lookAtCursor(page, file);
  // the wind came from 1 rad
  if (page.name === 'diagnose')
    check(/<img alt="A rose, north up. Wind from 057 ± \d+ deg \(ENE\); headings sailed: all/.test(readFileSync(file, 'utf8')), 'diagnose: a rose shows where the wind came from');
}
browser.close();
console.log(failures ? `${failures} failures` : `${PAGES.length} pages looked at`);
process.exit(failures ? 1 : 0);
