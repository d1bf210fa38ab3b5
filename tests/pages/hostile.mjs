// Files of somebody who means harm: a ship, recordings, a plan and indices with hostile words in every text, every file name
// and the names of their folders, through every command. On no page does a script of theirs run or an element of theirs stand,
// no terminal obeys what is printed, and no file is made but those that were asked for.
//
//   node hostile.mjs PROGRAM PROJECT FOLDER      77: there is no Chromium, so that pages were not opened
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { chromium, open, tab, valueOf } from './browser.mjs';

const [program, project, folder] = process.argv.slice(2).map((path) => resolve(path));

let failures = 0;
function check(holds, sentence) {
  if (holds) return;
  failures += 1;
  console.error(`not true: ${sentence}`);
}

// ---------------------------------------------------------------- words

// What ends a text, an attribute, a script, a comment or a cell; what Plotly, gnuplot, a shell, TOML, JSON and a spreadsheet obey;
// what a terminal obeys.
const SCRIPT = 'window.RAN=1';
const MARKUP = `"><script>${SCRIPT}</script><img src=x onerror="${SCRIPT}"><evil-element>'</title></style></script><!--`;
const COMMANDS = '`touch made` $(touch made) @system("touch made") %{x} {{data}} {/Bold x} javascript:0 <a href="http://evil.example">a</a> | =cmd()';
const CONTROLS = '\x1b]0;RAN\x07\x1b[31m\x9b31m\x7f\u202eevil\u2028\u2066';
const EVIL = `${MARKUP} ${COMMANDS} ${CONTROLS}`;

// The same as a part of a path; the folder ends where a closing tag has its slash.
const EVIL_FOLDER = `"><script>${SCRIPT}<`, EVIL_FILE = `script>'\`touch made\`<img src=x onerror=${SCRIPT}><evil-element>\x1b[31m\x9b\u202e\n`;
const LONG = 'n'.repeat(240);

const quoted = (text) => JSON.stringify(text).replace(/[\x7f-\x9f\u2028\u202e\u2066]/g, (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`);

// ---------------------------------------------------------------- files

rmSync(folder, { recursive: true, force: true });
const home = join(folder, 'work'), from = join(folder, EVIL_FOLDER), pages = join(folder, 'pages');
for (const place of [home, from, pages]) mkdirSync(place, { recursive: true });

function written(name, text) {
  const file = join(from, name);
  writeFileSync(file, text);
  return file;
}

const source = (...parts) => readFileSync(join(project, ...parts), 'utf8');
const named = (name) => source('ships', `${name}.toml`).replace(/^name = .*$/m, `name = ${quoted(EVIL)}`);
const ship = written(`${EVIL_FILE}.toml`, `# ${MARKUP}\n${named('kvlcc2_l7')}`);
const linear = written(`${EVIL_FILE}_linear.toml`, named('tanker97'));
const nawigator = written('nawigator.toml', named('nawigator_ym'));
const indices = written(`${EVIL_FILE}_indices.toml`, `# ${MARKUP}\n${source('examples/indices/nawigator.toml')}`);

// Every run key, remarks of any name, a column that is not understood.
function hostile(recording) {
  const [head, ...rest] = recording.slice(recording.indexOf('time_s')).trimEnd().split('\n');
  const keys = ['manoeuvre', 'group', 'vessel', 'source', 'date', 'ship', 'note'].map((key) => `# ${key} = ${quoted(EVIL)}`);
  const column = `"${`${MARKUP} ${COMMANDS} \x1b[31m`.replaceAll('"', '""')}"`;
  return ['# rudder_positive = "port"', ...keys, `# ${MARKUP.replaceAll('=', ' ')}`, `${head},${column}`,
    ...rest.map((row, i) => `${row},${i % 2 ? `=cmd()${MARKUP.replaceAll(/[",]/g, '')}` : '\x1b[31m'}`)].join('\n');
}
const zigzag = written(`${EVIL_FILE}.csv`, hostile(source('examples/recordings/weak_rudder_zz10_10.csv')));
const turn = written(`${LONG}.csv`, hostile(source('examples/recordings/weak_rudder_turn35.csv')));
const raw = Buffer.concat([Buffer.from(join(folder, 'raw')), Buffer.from('/\xff\xfe\xc0\xaf<evil-element>.csv', 'latin1')]);
mkdirSync(join(folder, 'raw'));
writeFileSync(raw, hostile(source('examples/recordings/weak_rudder_zz10_10.csv')));

// Plans: one of draws, one of recordings in folders of hostile names. Their words are no options of the commands that are started.
const draws = written(`${EVIL_FILE}_plan.toml`,
  `# ${MARKUP}\ntask = "zigzag 10/10"\nships = [${quoted(`${EVIL_FILE}.toml`)}]\ndraws = 5\n[vary]\nN_v = { relative_sd = 0.05 }\n`);
const trials = written('trials.toml', `# ${MARKUP}\ntask = "trial"\nruns = ["./*.csv"]\n`);
const options = join(folder, 'options');
mkdirSync(options);
const target = join(folder, 'outside.html');
mkdirSync(join(options, `--report=${folder}`), { recursive: true });
writeFileSync(join(options, `--report=${target}`), source('examples/recordings/weak_rudder_zz10_10.csv'));
writeFileSync(join(options, 'plan.toml'), `task = "trial"\nruns = ["--report=${target}"]\n`);

// ---------------------------------------------------------------- what is printed

const ACTS = /[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff\ufffd]/;

/// Runs it in a folder of its own, in which nothing must appear. @param bash  an expression for the shell that makes words
function run(words, { code = 0, bash = null, cwd = home } = {}) {
  const [command, args] = bash ? ['bash', ['-c', `"$0" "$@" ${bash}`, program, ...words]] : [program, words];
  const { status, stdout, stderr } = spawnSync(command, args, { encoding: 'utf8', cwd, maxBuffer: 1 << 28 });
  const said = `swayaw ${words.map((word) => word.replaceAll(folder, '').slice(0, 20)).join(' ')}`;
  check(status === code, `${said}: exit code ${code}, not ${status}: ${JSON.stringify(stderr.slice(-400))}`);
  for (const [name, text] of [['stdout', stdout], ['stderr', stderr]]) {
    const found = ACTS.exec(text);
    check(!found, `${said}: nothing on ${name} acts: ${found && JSON.stringify(text.slice(Math.max(0, found.index - 60), found.index + 20))}`);
  }
  return { said, stdout, stderr };
}

const reported = [];
function report(name, words, more) {
  const file = join(pages, `${name}.html`);
  run([...words, '--report', file], more);
  check(existsSync(file), `${name}: there is a page`);
  if (existsSync(file)) reported.push(name);
}

function document(words) {
  const { said, stdout } = run([...words, '--json']);
  try {
    return JSON.parse(stdout);
  } catch (error) {
    check(false, `${said}: is JSON (${error.message})`);
    return {};
  }
}

const out = (name) => join(folder, name);
report('indices', ['indices', linear]);
report('loop', ['loop', linear, '--zigzag', '10/10']);
for (const manoeuvre of ['--zigzag 10/10', '--turn 35', '--spiral', '--reverse-spiral', '--pullout 15', '--williamson', '--imo', '--straight 30'])
  report(`simulate${manoeuvre.replace(/\W/g, '')}`, ['simulate', ship, ...manoeuvre.split(' ')]);
report('simulate_linear', ['simulate', linear, '--zigzag', '10/10']);
report('check', ['check', zigzag, turn]);
report('check_raw', ['check'], { bash: `"${folder}"/raw/*.csv` });
report('trial', ['trial', zigzag, turn, '--ship', ship]);
report('compare', ['compare', ship, zigzag, turn]);
report('tune', ['tune', nawigator, '--indices', indices, '--prior', '1', '--bound', '1', '--turns', '20', '--out', out('tuned.toml')]);
const identify = ['identify', zigzag, '--ship', ship, '--find', 'Y_v,N_v'];
report('identify', [...identify, '--model', 'mmg', '--fit', 'forces', '--holdout', zigzag, '--out', out('identified.toml')]);
report('identify_linear', ['identify', zigzag, '--ship', ship, '--model', 'linear', '--out', out('linear.toml')]);
report('diagnose', ['diagnose', ship, zigzag, '--holdout', turn, '--save-model', out('diagnosed.toml')]);
report('sweep', ['sweep', draws, '--out', out('swept')]);
report('sweep_trials', ['sweep', trials, '--out', out('judged'), '--csv', out('judged.csv')]);

run(['compare', ship, zigzag, '--markdown']);
run(['replay', ship, zigzag, '--out', out('replayed.csv')]);
run(['trial', out('replayed.csv')]);  // its run keys are read again
run(['linearize', ship]);
run(['forces', ship, '--state', 'u=1,delta=0.1']);
run(['invert', linear]);
run(['ship', ship, '--out', out('again.toml')]);
run(['ship', out('again.toml')]);  // its name and what is remarked above do not end their lines
run(['import', zigzag, '--out', out('imported.csv'), '--split']);
run(['simulate', ship, '--turn', '35', '--out', out('turn.mat'), '--svg', out('turn.svg')]);
check(document(['ship', ship]).ship === EVIL, 'a document has the name of the ship as it is');
for (const words of [['check', zigzag], ['trial', zigzag], ['compare', ship, zigzag], ['indices', linear], ['sweep', trials, '--out', out('judged')],
  ['import', zigzag, '--out', out('imported.csv')]]) document(words);

// Refusals: of a key, of a command, of an option, of a file that is not there, of a value.
const refused = [[['ship', written('key.toml', `${named('kvlcc2_l7')}\n["${'x'.repeat(300)}\\u001b[31m\\u202e"]\na = 1\n`)], 1], [[`${EVIL_FILE}`], 2],
  [['ship', ship, `--${EVIL_FILE}`], 2], [['ship', join(from, `${EVIL}`.replaceAll('/', ''))], 1], [['simulate', ship, '--zigzag', EVIL], 2],
  [['check', written('cell.csv', `time_s,psi_rad,delta_rad\n0,0,0\n1,\x1b[31m\x9b\u202e,0\n`)], 1],
  [['sweep', written('bad.toml', `task = "zigzag 10/10"\n"\\u001b[31m" = 1\n`), '--out', out('bad')], 1]];
for (const [words, code] of refused) run(words, { code });

// A path of a plan that looks like an option stays a path.
run(['sweep', 'plan.toml', '--out', out('options_swept')], { cwd: options });
check(!existsSync(target), 'a plan cannot have a page written');

// Nothing but what was asked for.
check(readdirSync(home).length === 0, `nothing was made in the current folder: ${readdirSync(home)}`);
const asked = ['work', EVIL_FOLDER, 'pages', 'raw', 'options', 'tuned.toml', 'identified.toml', 'linear.toml', 'diagnosed.toml', 'swept', 'judged',
  'judged.csv', 'replayed.csv', 'again.toml', 'imported.csv', 'turn.mat', 'turn.svg', 'options_swept', 'bad'];
const others = readdirSync(folder).filter((name) => !asked.includes(name) && !/^imported_\d+_[\w.]+$/.test(name));
check(others.length === 0, `no file was made that was not asked for: ${others}`);

// The current folder is not where programs and plugins come from.
const foreign = join(folder, 'foreign');
mkdirSync(join(foreign, 'sweep'), { recursive: true });
for (const name of ['gnuplot', 'sweep/swayaw_mpi.so', 'swayaw_mpi.so']) writeFileSync(join(foreign, name), '#!/bin/sh\ntouch made\n', { mode: 0o755 });
spawnSync(program, ['indices', linear, '--report', join(foreign, 'page.html')], { cwd: foreign, env: { ...process.env, PATH: `.::${process.env.PATH}` } });
const ranks = spawnSync(program, ['sweep', '/dev/null', '--out', 'swept'],
  { cwd: foreign, env: { ...process.env, OMPI_COMM_WORLD_SIZE: '2', PATH: '' }, encoding: 'utf8', timeout: 20000 });
check(!/invalid ELF header|file too short/.test(ranks.stderr), `no plugin of the current folder is loaded: ${ranks.stderr}`);
check(!existsSync(join(foreign, 'made')), 'no program of the current folder is started');

// What the documents say of sizes is what the program says.
const usual = /default:\s+(\d+)GB\s+of\s+samples,\s+(\d+)MB\s+of\s+a\s+ship/.exec(run(['check', '--help']).stdout);
for (const document of ['security.md', 'commands.md'])
  for (const size of usual ? [`${usual[1]} GB`, `${usual[2]} MB`] : ['the sizes'])
    check(source('docs', document).includes(size), `docs/${document} has ${size}, as the help has`);

// ---------------------------------------------------------------- the pages

if (!chromium()) {
  console.log('[skipped] the pages are not opened: there is no Chromium');
  process.exit(failures ? 1 : 77);
}

// Elements and links that no page has by itself, and whether a script of theirs ran; all plots are drawn first.
const FOUND = `new Promise((then) => {
  dispatchEvent(new Event('beforeprint'));
  for (const node of document.querySelectorAll('a, button, .plot')) node.dispatchEvent(new Event('mouseover', { bubbles: true }));
  setTimeout(() => then({
    ran: window.RAN === 1, shown: document.querySelector('main')?.textContent.includes('evil-element'),
    drawn: document.querySelectorAll('.plot').length === document.querySelectorAll('.js-plotly-plot').length,
    foreign: [...document.querySelectorAll('evil-element, img:not([src^="data:image/svg+xml"]), iframe, object, embed, form, base, main script')].map((e) => e.outerHTML.slice(0, 80)),
    links: [...document.querySelectorAll('a')].map((a) => a.getAttribute('href') ?? a.getAttribute('xlink:href')).filter((to) => to !== null && !to.startsWith('#')),
    handlers: [...document.querySelectorAll('*')].flatMap((e) => e.getAttributeNames()).filter((name) => name.startsWith('on')),
    acts: /[\\u0000-\\u0008\\u000b-\\u001f\\u007f-\\u009f\\u200e\\u200f\\u2028-\\u202e\\u2066-\\u2069]/.test(document.documentElement.outerHTML),
  }), 300);
})`;

const browser = await tab();
await browser.ask('Page.enable');

async function opened(file) {
  await open(browser, file);
  await valueOf(browser, 'new Promise((then) => setTimeout(then, 200))');
  return valueOf(browser, FOUND);
}

// Each page as it is, and without the policy by which the browser runs no script but its own: nothing may rest on that alone.
const POLICY = /<meta http-equiv="Content-Security-Policy"[^>]*>/;
for (const name of reported) {
  const file = join(pages, `${name}.html`), html = readFileSync(file, 'utf8');
  check(POLICY.test(html) && !/script-src[^;]*unsafe/.test(html), `${name}: the page has a policy for scripts`);
  const bare = join(pages, `${name}_bare.html`);
  writeFileSync(bare, html.replace(POLICY, ''));
  for (const place of [file, bare]) {
    const found = await opened(place), which = place === bare ? `${name}, without its policy` : name;
    check(!found.ran, `${which}: no script of the files runs`);
    check(found.drawn, `${which}: its own scripts run, all plots are drawn`);
    check(found.foreign.length === 0, `${which}: no element of the files: ${found.foreign}`);
    check(found.links.length === 0, `${which}: no link of the files: ${found.links}`);
    check(found.handlers.length === 0, `${which}: no handler of the files: ${found.handlers}`);
    check(!found.acts, `${which}: no character acts`);
    check(found.shown, `${which}: the words of the files are shown`);
  }
}

// A script that slipped through is seen by these checks, and the policy alone holds it back.
const smuggled = join(pages, 'smuggled.html');
for (const name of ['loop', 'loop_bare']) {
  const html = readFileSync(join(pages, `${name}.html`), 'utf8');
  writeFileSync(smuggled, html.replace('<main>', `<main><script>${SCRIPT}</script><img src="x" onerror="${SCRIPT}">`));
  const found = await opened(smuggled);
  check(found.foreign.length === 2 && found.handlers.length === 1, `${name}: elements that slipped through are seen`);
  check(found.ran === (name === 'loop_bare'), `${name}: a script that slipped through runs without the policy only`);
}
browser.close();

console.log(failures ? `${failures} failures` : `${reported.length} pages opened`);
process.exit(failures ? 1 : 0);
