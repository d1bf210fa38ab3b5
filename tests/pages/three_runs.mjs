// Three recordings of a thousand samples: a model of a tanker in wind, made by `swayaw simulate`.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const WIND = '\n[[effect]]\nkind = "steady_wind"\nwind_speed_m_s = 4.0\nwind_from_rad = 1.0\n';
const MANOEUVRES = [['--zigzag', '10/10'], ['--zigzag', '20/20'], ['--turn', '35']];

/// Her ship file, which knows of no wind, and the files of the three recordings.
export function threeRuns(program, project, folder) {
  const ship = join(project, 'ships/kvlcc2_l7.toml'), windy = join(folder, 'windy.toml');
  writeFileSync(windy, readFileSync(ship, 'utf8') + WIND);
  const runs = MANOEUVRES.map((words) => {
    const file = join(folder, `${words.join('').replace(/\W/g, '')}.csv`);
    execFileSync(program, ['simulate', windy, ...words, '--step', '0.1', '--duration', '99.9', '--out', file], { stdio: 'ignore' });
    return file;
  });
  return { ship, runs };
}

/// The pages that hold their samples.
export const pagesOf = ({ ship, runs }) => [
  { name: 'trial', words: ['trial', ...runs, '--ship', ship] },
  { name: 'check', words: ['check', ...runs] },
  { name: 'compare', words: ['compare', ship, ...runs] },
  { name: 'diagnose', words: ['diagnose', ship, ...runs] },
];
