// How long the pages of three runs of a thousand samples take to open: the first screen painted, and everything drawn.
//
//   node opening_time.mjs PROGRAM FOLDER
import { execFileSync } from 'node:child_process';
import { mkdirSync, statSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { tab, valueOf } from './browser.mjs';
import { pagesOf, threeRuns } from './three_runs.mjs';

const [program, folder] = process.argv.slice(2).map((path) => resolve(path));
const project = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const OPENINGS = 9;

// Milliseconds from the start of the navigation to the first paint of anything, and until every plot within 800 px of the
// screen is drawn; and as many as drawing all others takes, as for print.
const measured = `new Promise((then) => {
  const isNear = (plot) => plot.getBoundingClientRect().top < innerHeight + 800;
  const look = () => {
    const [painted] = performance.getEntriesByName('first-contentful-paint'), plots = [...document.querySelectorAll('.plot')];
    const drawn = plots.length > 0 && plots.filter(isNear).every((plot) => plot.classList.contains('js-plotly-plot'));
    if (!painted || !drawn) return setTimeout(look, 10);
    const near = performance.now();
    dispatchEvent(new Event('beforeprint'));
    then([painted.startTime, near, performance.now() - near]);
  };
  look();
})`;

async function opened(file) {
  const page = await tab();
  await page.ask('Page.enable');
  await page.ask('Page.navigate', { url: `file://${file}` });
  const times = await valueOf(page, measured);
  page.close();
  return times;
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

mkdirSync(folder, { recursive: true });
console.log('| page | size, MB | first screen, s | plots near it, s | all others, s |\n| --- | ---: | ---: | ---: | ---: |');
for (const { name, words } of pagesOf(threeRuns(program, project, folder))) {
  const file = join(folder, `${name}.html`);
  execFileSync(program, [...words, '--report', file], { stdio: 'ignore' });
  const times = [];
  for (let i = 0; i < OPENINGS; i += 1) times.push(await opened(file));
  const seconds = [0, 1, 2].map((i) => (median(times.map((time) => time[i])) / 1000).toFixed(2));
  console.log(`| ${name} | ${(statSync(file).size / 1e6).toFixed(2)} | ${seconds.join(' | ')} |`);
}
