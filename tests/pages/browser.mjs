// Headless Chromium, and what it is asked by its DevTools protocol over a pipe.
import { spawn, spawnSync } from 'node:child_process';

/// The name of its program; undefined where there is none.
export const chromium = () => ['chromium', 'chromium-browser', 'google-chrome'].find((name) => spawnSync(name, ['--version']).status === 0);

export const HEADLESS = ['--headless', '--no-sandbox', '--disable-gpu', '--hide-scrollbars'];

/// A tab. ask(method, parameters) answers as the protocol does; close() ends the browser.
export async function tab(size = [1400, 900]) {
  const browser = spawn(chromium(), [...HEADLESS, '--remote-debugging-pipe', `--window-size=${size}`], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const [, , , to, from] = browser.stdio;
  const waiting = new Map();
  let rest = '';
  from.on('data', (piece) => {
    const messages = (rest + piece).split('\0');
    rest = messages.pop();
    for (const { id, result, error } of messages.map(JSON.parse).filter(({ id }) => waiting.has(id))) {
      const { resolve, reject } = waiting.get(id);
      waiting.delete(id);
      if (error) reject(new Error(error.message));
      else resolve(result);
    }
  });
  let last = 0;
  const send = (method, params, sessionId) => new Promise((resolve, reject) => {
    waiting.set(last += 1, { resolve, reject });
    to.write(`${JSON.stringify({ id: last, method, params, sessionId })}\0`);
  });
  const { targetId } = await send('Target.createTarget', { url: 'about:blank' });
  const { sessionId } = await send('Target.attachToTarget', { targetId, flatten: true });
  return { ask: (method, params = {}) => send(method, params, sessionId), close: () => browser.kill() };
}

/// The value of an expression in the page, awaited.
export async function valueOf({ ask }, expression) {
  const { result, exceptionDetails } = await ask('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
  if (exceptionDetails) throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
  return result.value;
}
