// Every command of the documentation: those of code blocks, and the examples of each --help, are run; of those that stand for others,
// as `swayaw compare SHIP RUN.csv...`, and of those within sentences, command and options must exist.
//
//   node commands.mjs PROGRAM PROJECT FOLDER
import { spawnSync } from 'node:child_process';
import { copyFileSync, cpSync, mkdirSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';

const [program, project, folder] = process.argv.slice(2).map((path) => resolve(path));
const env = { ...process.env, PATH: `${dirname(program)}:${process.env.PATH}` };

let failures = 0;
function check(holds, sentence) {
  if (holds) return;
  failures += 1;
  console.error(`not true: ${sentence}`);
}

const run = (line, cwd) => spawnSync('bash', ['-c', line], { cwd, env, encoding: 'utf8', maxBuffer: 1 << 28 });

// ---------------------------------------------------------------- what the documents say

const documents = ['README.md', 'CONTRIBUTING.md',
  ...readdirSync(join(project, 'docs'), { recursive: true }).filter((name) => name.endsWith('.md')).map((name) => `docs/${name}`)];

/// Of these the commands are run elsewhere: by guide.sh, with the exports that it describes; by the scripts that make results.
const isRunElsewhere = (document) => document === 'docs/from_my_spreadsheet.md' || /^docs\/.*\//.test(document);

/// Of these the options are not only swayaw's.
const isOfOthers = (document) => ['README.md', 'CONTRIBUTING.md', 'docs/building.md', 'docs/concealed_on_board.md'].includes(document) || /^docs\/.*\//.test(document);

/// Lines of code blocks, fenced or indented, and the code within sentences.
function codeOf(text) {
  const blocks = [], spans = [];
  let fenced = false;
  for (const line of text.split('\n')) {
    if (line.startsWith('```')) fenced = !fenced;
    else if (fenced || line.startsWith('    ')) blocks.push(line.trim().replace(/^\$ /, ''));
    else spans.push(...[...line.matchAll(/`([^`]+)`/g)].map(([, code]) => code));
  }
  return { blocks, spans };
}

const isCommand = (line) => /^swayaw\s+[a-z-]/.test(line);
const withoutRemark = (line) => line.replace(/\s\s+#.*$/, '');
const isRefused = (line) => /#.*\brefused\b/.test(line);

/// A command that stands for others: SHIP, RUN.csv, [--option], D/H, model a|b, …
const isPattern = (line) => /\b[A-Z][A-Z]+\b(?!\.md)|\.\.\.|…|[[\]|]|--\w+ [A-Z]\b/.test(line.replace(/MSC\.137\(76\)/g, ''));

// ---------------------------------------------------------------- options

const helps = new Map();
function helpOf(command) {
  if (!helps.has(command)) helps.set(command, run(`swayaw ${command} --help`, folder));
  return helps.get(command);
}

/// Whether the help has it at the beginning of a line: other options name it behind "Needs:".
const hasOption = (command, option) => new RegExp(`^ *(-h,)?${option}\\b(?!-)`, 'm').test(helpOf(command).stdout);

function checkOptions(line, where) {
  const [, command] = line.split(/\s+/);
  if (command.startsWith('-')) return;
  const { status } = helpOf(command);
  check(status === 0, `${where}: there is a command ${command}`);
  for (const [option] of line.matchAll(/--[a-z][a-z-]*/g)) check(hasOption(command, option), `${where}: swayaw ${command} has ${option}`);
}

// ---------------------------------------------------------------- commands that are run

/// Recordings by the names that documents use, as `swayaw simulate` and loggers leave them.
const RECORDINGS = {
  'zz10.csv': 'weak.toml --zigzag 10/10', 'zz15.csv': 'weak.toml --zigzag 15/15', 'zz20.csv': 'weak.toml --zigzag 20/20',
  'turn35.csv': 'weak.toml --turn 35', 'turn.csv': 'weak.toml --turn 35 --first port', 'run.csv': 'weak.toml --zigzag 20/20',
  'run1.csv': 'weak.toml --zigzag 10/10', 'run2.csv': 'weak.toml --turn 20', 'log.csv': 'weak.toml --zigzag 10/10',
  'drift.csv': 'windy.toml --turn 35 --duration 1500 --step 1',
};
const WIND = '\n[[effect]]\nkind = "steady_wind"\nwind_speed_m_s = 10.0\nwind_from_rad = 1.0\n';

function provide(place) {
  mkdirSync(place, { recursive: true });
  for (const name of ['ships', 'examples']) symlinkSync(join(project, name), join(place, name));
  writeFileSync(join(place, 'windy.toml'), readFileSync(join(project, 'ships/kvlcc2.toml'), 'utf8') + WIND);
  const ship = readFileSync(join(project, 'ships/kvlcc2_l7.toml'), 'utf8');
  writeFileSync(join(place, 'ship.toml'), ship);
  writeFileSync(join(place, 'weak.toml'), ship.replace(/^f_alpha = .*$/m, 'f_alpha = 2.25'));
  for (const name of readdirSync(join(project, 'examples/recordings'))) copyFileSync(join(project, 'examples/recordings', name), join(place, name));
  for (const [name, words] of Object.entries(RECORDINGS))
    check(run(`swayaw simulate ${words} --out ${name}`, place).status === 0, `${name} can be made`);
  // a log of two days, and what it does not say itself
  const [head, ...rows] = readFileSync(join(place, 'log.csv'), 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
  for (const [name, half] of [['day1.csv', rows.slice(0, 300)], ['day2.csv', rows.slice(300)]]) writeFileSync(join(place, name), `${[head, ...half].join('\n')}\n`);
  writeFileSync(join(place, 'map.toml'), 'decimal = "."\n');
  check(run(`${join(project, 'examples/fleet.sh')} ${program} two_sisters`, place).status === 0, 'a fleet can be made');
  for (const name of ['athena', 'boreas']) symlinkSync(join('two_sisters', name), join(place, name));
  writeFileSync(join(place, 'plan.toml'), 'task = "zigzag 10/10"\nships = ["ship.toml"]\ndraws = 100\nconfidence = true\n');
}

/// Runs the commands of a document, one after the other, in a folder of its own.
let places = 0;
function tryCommands(lines, where) {
  const place = join(folder, `${places += 1}`);
  cpSync(provided, place, { recursive: true, verbatimSymlinks: true });
  for (const line of lines) tryCommand(withoutRemark(line), where, place, isRefused(line));
  tried += lines.length;
}

function tryCommand(line, where, place, refused) {
  const { status, stderr } = run(line, place);
  const said = stderr.trim().split('\n').at(-1);
  check(status === (refused ? 1 : 0), `${where}: ${line}: exit code ${status}: ${said}`);
}

rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const provided = join(folder, 'provided');
provide(provided);
let tried = 0, looked = 0;

const commands = run('swayaw --help', folder).stdout.split('Subcommands:')[1].split('\n').map((line) => /^ {2}([a-z]+) /.exec(line)).filter(Boolean)
  .map(([, name]) => name);
check(commands.length > 10, 'swayaw --help names the commands');
for (const document of documents) {
  const { blocks, spans } = codeOf(readFileSync(join(project, document), 'utf8'));
  for (const line of [...blocks, ...spans].filter(isCommand)) checkOptions(withoutRemark(line), document), looked += 1;
  if (!isOfOthers(document))
    for (const [option] of spans.map((span) => /^--[a-z][a-z-]*/.exec(span)).filter(Boolean))
      check(commands.some((command) => hasOption(command, option)), `${document}: a command has ${option}`), looked += 1;
  if (!isRunElsewhere(document)) tryCommands(blocks.filter(isCommand).filter((text) => !isPattern(withoutRemark(text))), document);
}

for (const command of commands) {
  const [, examples] = helpOf(command).stdout.split('For example\n');
  tryCommands((examples || '').replace(/\\\n\s*/g, '').split('\n').map((text) => text.trim()).filter(isCommand), `swayaw ${command} --help`);
}
console.log(failures ? `${failures} failures` : `${tried} commands run, options of ${looked} looked at`);
process.exit(failures ? 1 : 0);
