// Headless Chromium, and what it is asked by its DevTools protocol over a pipe.
import { spawn, spawnSync } from 'node:child_process';

/// The name of its program; undefined where there is none.
export const chromium = () => ['chromium', 'chromium-browser', 'google-chrome'].find((name) => spawnSync(name, ['--version']).status === 0);

const HEADLESS = ['--headless', '--no-sandbox', '--disable-gpu', '--hide-scrollbars'];

/// A tab. ask(method, parameters) answers as the protocol does; when(event) is the next event of that name; each(event,
/// then) hears all of them; close() ends the browser.
export async function tab(size = [1400, 900]) {
  const browser = spawn(chromium(), [...HEADLESS, '--remote-debugging-pipe', `--window-size=${size}`], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const [, , , to, from] = browser.stdio;
  const waiting = new Map(), hearing = new Map();
  let rest = '';
  from.on('data', (piece) => {
    const messages = (rest + piece).split('\0');
    rest = messages.pop();
    for (const { id, result, error, method, params } of messages.map(JSON.parse)) {
      for (const then of hearing.get(method) ?? []) then(params);
      if (!waiting.has(id)) continue;
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
  const each = (event, then) => hearing.set(event, [...(hearing.get(event) ?? []), then]);
  const when = (event) => new Promise((then) => each(event, function once(params) {
    hearing.set(event, hearing.get(event).filter((other) => other !== once));
    then(params);
  }));
  return { ask: (method, params = {}) => send(method, params, sessionId), each, when, close: () => browser.kill() };
}

/// Opens a file and waits until it is loaded, pictures and all; the domain Page must be enabled.
export async function open({ ask, when }, file) {
  const loaded = when('Page.loadEventFired');
  await ask('Page.navigate', { url: `file://${encodeURI(file)}` });
  await loaded;
}

/// The value of an expression in the page, awaited.
export async function valueOf({ ask }, expression) {
  const { result, exceptionDetails } = await ask('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
  if (exceptionDetails) throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
  return result.value;
}
