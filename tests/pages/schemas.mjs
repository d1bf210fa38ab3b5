// The JSON of every command: each document has a schema and fits it, and docs/json.md is what the schemas say.
//
//   node schemas.mjs PROGRAM PROJECT FOLDER      77: ajv could not be fetched
import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { fetched } from './npm.mjs';

const [program, project, folder] = process.argv.slice(2).map((path) => resolve(path));
const { idOf, page, schemas } = await import(pathToFileURL(join(project, 'docs/schemas/make_page.mjs')));

let failures = 0;
function check(holds, sentence) {
  if (holds) return;
  failures += 1;
  console.error(`not true: ${sentence}`);
}

mkdirSync(folder, { recursive: true });
const made = readFileSync(join(project, 'docs/json.md'), 'utf8') === page();
check(made, 'docs/json.md is what node docs/schemas/make_page.mjs writes');
const ajv = fetched('ajv/dist/2020.js', folder);
if (!ajv) {
  console.log('[skipped] the documents are not held against their schemas: ajv could not be fetched');
  process.exit(failures ? 1 : 77);
}
const { Ajv2020: Ajv } = createRequire(import.meta.url)(ajv);
const judge = new Ajv({ allErrors: true, allowUnionTypes: true, strictTypes: false, strictRequired: false });
const all = schemas();
for (const schema of all.values()) judge.addSchema(schema);
const fileOf = new Map([...all].map(([file, schema]) => [idOf(schema), file]));
const seen = new Set();

// ---------------------------------------------------------------- one document

function holdAgainstSchema(text, words) {
  let document = null;
  try {
    document = JSON.parse(text);
  } catch (error) {
    return check(false, `${words}: one JSON document (${error.message})`);
  }
  check(Object.keys(document)[0] === 'schema', `${words}: the first key is schema`);
  const file = fileOf.get(document.schema);
  check(file !== undefined, `${words}: there is a schema for ${document.schema}`);
  if (!file) return;
  seen.add(document.schema);
  const fits = judge.getSchema(file);
  if (fits(document)) return;
  const faults = fits.errors.slice(0, 5).map((e) => `${e.instancePath} ${e.message} ${JSON.stringify(e.params)}`);
  check(false, `${words}: the document fits ${file}: ${faults.join('; ')}`);
}

function run(words) {
  return spawnSync(program, words, { encoding: 'utf8', maxBuffer: 1 << 28, cwd: folder });
}

const shortened = (words) => words.map((word) => (word.startsWith('/') ? basename(word) : word)).join(' ');

/// Runs it and judges what it prints. @param may  whether a refusal is an answer, too
function judged(words, may = false) {
  const { status, stdout, stderr } = run([...words, '--json']);
  const said = `swayaw ${shortened(words)}`;
  const complaint = stderr.trim().split('\n').at(-1);
  if (stdout === '') return check(may && status === 1, `${said}: prints a document (${complaint})`);
  check(status === 0 || may, `${said}: exit code 0, not ${status}`);
  holdAgainstSchema(stdout, said);
}

/// A recording that the program makes. @return its file
function recorded(name, words) {
  const file = join(folder, name);
  const { status, stderr } = run([...words, '--out', file]);
  check(status === 0, `swayaw ${shortened(words)}: writes ${name} (${stderr.trim()})`);
  return file;
}

function written(name, text) {
  const file = join(folder, name);
  writeFileSync(file, text);
  return file;
}

// ---------------------------------------------------------------- what is run

const ship = (name) => join(project, 'ships', `${name}.toml`);
const files = (place, end) => readdirSync(join(project, place)).filter((name) => name.endsWith(end)).sort()
  .map((name) => join(project, place, name));
const ships = files('ships', '.toml');
const recordings = files('examples/recordings', '.csv'), [turn, zigzag] = recordings;
const STATE = 'u=1,v=0.05,r=-0.01,delta=0.1';
const MANOEUVRES = ['--zigzag 10/10', '--zigzag 20/20', '--turn 20', '--turn 35 --first port', '--spiral', '--reverse-spiral',
  '--pullout 15', '--williamson', '--imo', '--straight 30'].map((words) => words.split(' '));

// Ships of every model: what one of them does not have is refused.
for (const file of ships) {
  for (const command of ['indices', 'invert', 'linearize', 'ship']) judged([command, file], true);
  judged(['loop', file, '--zigzag', '10/10'], true);
  judged(['forces', file, '--state', STATE], true);
  for (const manoeuvre of MANOEUVRES) judged(['simulate', file, ...manoeuvre], true);
  judged(['compare', file, ...recordings], true);
  judged(['replay', file, zigzag, '--out', join(folder, 'replay.csv')], true);
}
judged(['indices', ship('tanker97')]);
judged(['invert', ship('tanker97_nomoto'), '--parts', ship('tanker97'), '--known', 'Y_w']);
judged(['linearize', ship('wpcc_pi'), '--rudder', '10']);
judged(['linearize', ship('kvlcc2'), '--side', 'port']);
judged(['simulate', ship('kvlcc2'), '--turn', '35', '--duration', '50']);

// A ship in wind.
const wind = '\n[[effect]]\nkind = "steady_wind"\nwind_speed_m_s = 12.0\nwind_from_rad = 1.0\n';
const windy = written('windy.toml', readFileSync(ship('kvlcc2'), 'utf8') + wind);
judged(['forces', windy, '--state', STATE]);
judged(['simulate', windy, '--straight', '30']);
judged(['simulate', windy, '--imo']);

// Recordings of every manoeuvre, in calm and in wind.
const drift = recorded('circle.csv', ['simulate', windy, '--turn', '35', '--duration', '1500', '--step', '1']);
const inWind = recorded('zigzag.csv', ['simulate', windy, '--zigzag', '10/10', '--step', '1']);
const spiral = recorded('spiral.csv', ['simulate', ship('mariner'), '--spiral', '--step', '5']);
const rows = Array.from({ length: 200 }, (_, i) => `${i},${(0.001 * Math.sin(i)).toFixed(6)},0.01,5.0,0.1`);
const head = '# manoeuvre = "straight"\ntime_s,psi_rad,delta_rad,u_m_s,v_m_s';
const straight = written('straight.csv', `${head}\n${rows.join('\n')}\n`);
const inGroup = (file, i) => written(`group_${i}.csv`, `# group = "day ${i}"\n${readFileSync(file, 'utf8')}`);
const grouped = recordings.map(inGroup);
judged(['trial', ...recordings, '--ship', ship('kvlcc2_l7')]);
judged(['trial', drift, inWind, spiral, straight, '--length', '320']);
judged(['trial', zigzag]);
judged(['check', zigzag]);
judged(['check', ...recordings]);
judged(['check', ...grouped]);
judged(['import', zigzag, '--out', join(folder, 'imported.csv'), '--split']);

// Coefficients and effects.
const identified = ['--out', join(folder, 'identified.toml'), '--ship', ship('kvlcc2_l7')];
judged(['identify', zigzag, ...identified, '--model', 'linear']);
judged(['identify', zigzag, ...identified, '--model', 'mmg', '--find', 'Y_v,N_v', '--resample', '--holdout', turn], true);
judged(['identify', ...recordings, ...identified, '--model', 'mmg', '--find', 'N_v,N_r', '--fit', 'trajectories'], true);
const tuned = ['--prior', '1', '--bound', '1', '--turns', '20', '--out', join(folder, 'tuned.toml')];
for (const file of files('examples/indices', '.toml')) judged(['tune', ship('nawigator_ym'), '--indices', file, ...tuned]);
const dimensions = '--length 230 --beam 32.2 --draught 10.8 --block 0.651'.split(' ');
const estimated = ['estimate', ...dimensions, '--out', join(folder, 'estimated.toml')];
judged(estimated);
judged([...estimated, '--trim', '0.5', '--rudder-area', '40', '--depth', '19', '--speed', '12']);
judged(['diagnose', ship('kvlcc2_l7'), zigzag, '--holdout', turn]);
judged(['diagnose', ship('kvlcc2'), inWind, drift]);

// Two sisters over ten months.
spawnSync('bash', [join(project, 'examples/fleet.sh'), program, join(folder, 'two_sisters')]);
const days = ['athena', 'boreas'].flatMap((vessel) => readdirSync(join(folder, 'two_sisters', vessel)).map((name) => join('two_sisters', vessel, name)));
judged(['fleet', join(folder, 'two_sisters/class.toml'), ...days]);

// Sweeps: draws, a grid of which a part cannot be sailed, pairs.
const laws = { draws: 'draws = 20\nconfidence = true\n',
  grid: 'design = "grid"\n[vary]\nmax_angle_deg = { values = [35.0, 5.0] }\n',
  sobol: 'design = "sobol"\npairs = 20\n[vary]\nN_v = { relative_sd = 0.05 }\nY_v = { relative_sd = 0.05 }\n' };
for (const [design, law] of Object.entries(laws))
  for (const task of ['zigzag 10/10', 'turn 35', 'indices']) {
    const name = `${design}_${task.replace(/\W/g, '_')}`;
    const plan = written(`${name}.toml`, `task = "${task}"\nships = ["kvlcc2"]\n${law}`);
    judged(['sweep', plan, '--out', join(folder, name)]);
  }

const trials = written('trials.toml', `task = "trial"\nruns = ["${join(project, 'examples/recordings')}/*.csv"]\n`);
judged(['sweep', trials, '--out', join(folder, 'trials')]);
mkdirSync(join(folder, 'cases/one/train'), { recursive: true });
written('cases/one/train/zigzag.csv', readFileSync(zigzag));
const cases = written('cases.toml', 'task = "diagnose"\ncases = ["cases/*"]\nship = "kvlcc2_l7"\n');
judged(['sweep', cases, '--out', join(folder, 'diagnosed')]);

for (const id of fileOf.keys()) check(seen.has(id), `a document of ${id} was printed`);
console.log(failures ? `${failures} failures` : `documents of ${seen.size} kinds fit their schemas`);
process.exit(failures ? 1 : 0);
