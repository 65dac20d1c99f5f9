// A browser without a window, spoken to through two pipes: tabs, widths, colours and keys, with no library
// beside Node.
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

/// The first browser on the path, null where there is none.
export function findChromium() {
  for (const name of [process.env.CHROMIUM, 'chromium', 'chromium-browser', 'google-chrome'].filter(Boolean))
    for (const folder of name.includes('/') ? [''] : (process.env.PATH ?? '').split(':')) {
      const file = path.join(folder, name);
      if (fs.existsSync(file)) return file;
    }
  return null;
}

export class Browser {
  static async start(program) {
    const browser = new Browser();
    browser.folder = fs.mkdtempSync(path.join(os.tmpdir(), 'book_pages_'));
    browser.process = spawn(
      program,
      [
        '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
        '--disable-background-networking', '--disable-component-update', '--disable-sync',
        '--disable-extensions', '--mute-audio', '--hide-scrollbars=false', '--allow-file-access-from-files',
        `--user-data-dir=${browser.folder}`, '--remote-debugging-pipe', 'about:blank'
      ],
      {
        stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'],
        env: {...process.env, DBUS_SESSION_BUS_ADDRESS: 'disabled:' }
      });
    browser.answers = new Map();
    browser.tabs = new Map();
    browser.count = 0;
    let rest = [];
    browser.process.stdio[4].on('data', (piece) => {
      for (let end; (end = piece.indexOf(0)) >= 0; piece = piece.subarray(end + 1)) {
        browser.take(JSON.parse(Buffer.concat([...rest, piece.subarray(0, end)]).toString()));
        rest = [];
      }
      if (piece.length) rest.push(piece);
    });
    // A browser that ends breaks its pipes; whoever waits for an answer is told.
    for (const pipe of [3, 4]) browser.process.stdio[pipe].on('error', () => {});
    browser.process.on('exit', () => {
      browser.ended = true;
      for (const { fail } of browser.answers.values()) fail(new Error('the browser has ended'));
    });
    await browser.ask('Browser.getVersion');
    return browser;
  }
  take(message) {
    if (message.id) {
      const { done, fail, method } = this.answers.get(message.id);
      this.answers.delete(message.id);
      return message.error ? fail(new Error(`${method}: ${message.error.message}`)) : done(message.result);
    }
    this.tabs.get(message.sessionId)?.hear(message);
  }
  ask(method, params = {}, sessionId = undefined) {
    if (this.ended) return Promise.reject(new Error('the browser has ended'));
    const id = ++this.count;
    return new Promise((done, fail) => {
      this.answers.set(id, { done, fail, method });
      this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + '\0');
    });
  }
  async tab() {
    const { targetId } = await this.ask('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.ask('Target.attachToTarget', { targetId, flatten: true });
    const tab = new Tab(this, sessionId);
    this.tabs.set(sessionId, tab);
    for (const domain of ['Page', 'Runtime', 'Log']) await tab.ask(`${domain}.enable`);
    return tab;
  }
  async close() {
    if (!this.ended) {
      await Promise.race([this.ask('Browser.close').catch(() => {}), wait(3000)]);
      for (let k = 0; k < 30 && !this.ended; ++k) await wait(100);
      if (!this.ended) this.process.kill('SIGKILL');
    }
    fs.rmSync(this.folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

class Tab {
  constructor(browser, session) { Object.assign(this, { browser, session, said: [], waiting: [] }); }
  ask(method, params) { return this.browser.ask(method, params, this.session); }
  hear({ method, params }) {
    if (method === 'Page.loadEventFired')
      for (const done of this.waiting.splice(0)) done();
    if (method === 'Runtime.exceptionThrown')
      this.said.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type))
      this.said.push(params.args.map((a) => a.value ?? a.description).join(' '));
    if (method === 'Log.entryAdded' && ['error', 'warning'].includes(params.entry.level))
      this.said.push(`${params.entry.text} ${params.entry.url ?? ''}`);
  }
  /// A viewport, and a preference for light or dark colours.
  async look(width, height, colours) {
    await this.ask(
      'Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
    await this.colours(colours);
  }
  colours(scheme) {
    return this.ask('Emulation.setEmulatedMedia', {
      features:
        [{ name: 'prefers-color-scheme', value: scheme }, { name: 'prefers-reduced-motion', value: 'reduce' }]
    });
  }
  async open(url) {
    // Another page first, or a change of the anchor alone would load nothing.
    if (url.includes('#')) await this.go('about:blank');
    this.said = [];
    await this.go(url);
  }
  async go(url) {
    const loaded = new Promise((done) => this.waiting.push(done));
    const { errorText } = await this.ask('Page.navigate', { url });
    if (errorText) throw new Error(`${url}: ${errorText}`);
    let late;
    await Promise.race([
      loaded, new Promise((_, fail) => {
        late = setTimeout(() => fail(new Error(`${url}: not loaded within 30 s`)), 30000);
      })
    ]);
    clearTimeout(late);
  }
  async run(expression) {
    const { result, exceptionDetails } =
      await this.ask('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  /// Asks again and again until the answer is true, or the time is over.
  async until(expression, milliseconds) {
    for (const end = Date.now() + milliseconds; Date.now() < end; await wait(25))
      if (await this.run(expression)) return true;
    return false;
  }
  async press(key, code = 0) {
    const same = {
      key,
      code: key === ' ' ? 'Space' : key,
      windowsVirtualKeyCode: code,
      ...(key === ' ' ? { text: ' ' } : {})
    };
    await this.ask('Input.dispatchKeyEvent', { type: key === ' ' ? 'keyDown' : 'rawKeyDown', ...same });
    await this.ask('Input.dispatchKeyEvent', { type: 'keyUp', ...same });
  }
  type(text) { return this.ask('Input.insertText', { text }); }
  async picture(file, whole = false) {
    const { data } =
      await this.ask('Page.captureScreenshot', { format: 'png', captureBeyondViewport: whole });
    fs.writeFileSync(file, Buffer.from(data, 'base64'));
  }
}
export {wait};
