// The packages of package.json beside this file, as npm has them.
import { spawnSync } from 'node:child_process';
import { copyFileSync, existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));

/// A file of them, fetched into a folder once; null where there is no network.
export function fetched(file, folder) {
  const path = join(folder, 'node_modules', file);
  if (!existsSync(path)) {
    for (const name of ['package.json', 'package-lock.json']) copyFileSync(join(here, name), join(folder, name));
    spawnSync('npm', ['ci', '--prefer-offline', '--ignore-scripts', '--no-audit', '--no-fund'], { cwd: folder });
  }
  return existsSync(path) ? path : null;
}
