// The distribution's Chromium without a window, through its protocol on two pipes: what a page
// looks like and says, with keys, clicks and touches of a person.

import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

const patience = 60000; // milliseconds that an answer may take

const options = ['--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle',
                 '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-background-networking',
                 '--disable-component-update', '--no-first-run', '--force-color-profile=srgb',
                 '--hide-scrollbars', '--remote-debugging-pipe'];

const codes = {Escape: 27, ArrowUp: 38, ArrowDown: 40, ArrowLeft: 37, ArrowRight: 39};

export const pause = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));

export class Browser {
  // \throws when the program does not answer
  static async start(program, more_options = []) {
    const browser = new Browser();
    browser.profile = mkdtempSync(join(tmpdir(), 'acmap_browser_'));
    browser.process = spawn(program, [...options, ...more_options, `--user-data-dir=${browser.profile}`, 'about:blank'],
                            {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    browser.waiting = new Map();
    browser.pages = new Map();
    browser.last_id = 0;
    browser.ended = new Promise(resolve => browser.process.on('exit', resolve));
    browser.process.stdio[3].on('error', () => {});
    browser.readMessages(browser.process.stdio[4]);
    await browser.call('Target.setDiscoverTargets', {discover: true});
    return browser;
  }

  readMessages(stream) {
    let rest = [];
    stream.on('data', chunk => {
      for (let end = chunk.indexOf(0); end >= 0; end = chunk.indexOf(0)) {
        rest.push(chunk.subarray(0, end));
        this.take(JSON.parse(Buffer.concat(rest).toString()));
        rest = [];
        chunk = chunk.subarray(end + 1);
      }
      rest.push(chunk);
    });
  }

  take(message) {
    const asked = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (asked && message.error)
      asked.reject(new Error(`${asked.method}: ${message.error.message}`));
    else if (asked)
      asked.resolve(message.result);
    else
      this.pages.get(message.sessionId)?.take(message);
  }

  call(method, params = {}, sessionId = undefined) {
    const id = ++this.last_id;
    this.process.stdio[3].write(`${JSON.stringify({id, method, params, sessionId})}\0`);
    return new Promise((resolve, reject) => {
      const timer = setTimeout(() => reject(new Error(`${method}: no answer`)), patience);
      const done = finish => value => {
        clearTimeout(timer);
        finish(value);
      };
      this.waiting.set(id, {method, resolve: done(resolve), reject: done(reject)});
    });
  }

  // A new page of a size, as of a computer or of a telephone.
  async open(url, {width = 1280, height = 800, touch = false, ratio = 1} = {}) {
    const {targetId} = await this.call('Target.createTarget', {url: 'about:blank'});
    const {sessionId} = await this.call('Target.attachToTarget', {targetId, flatten: true});
    const page = new Page(this, sessionId, targetId, {width, height});
    this.pages.set(sessionId, page);
    await page.call('Page.enable');
    await page.call('Runtime.enable');
    await page.call('Log.enable');
    await page.call('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: ratio, mobile: touch});
    await page.call('Emulation.setTouchEmulationEnabled', {enabled: touch, maxTouchPoints: touch ? 5 : 1});
    await page.go(url);
    return page;
  }

  async stop() {
    this.call('Browser.close').catch(() => {});
    await Promise.race([this.ended, pause(5000)]);
    this.process.kill('SIGKILL');
    rmSync(this.profile, {recursive: true, force: true, maxRetries: 5});
  }
}

class Page {
  constructor(browser, session, target, size) {
    Object.assign(this, {browser, session, target, size});
    this.errors = []; // what the page wrote as errors, or threw
    this.requests = []; // addresses outside of the page
  }

  take({method, params}) {
    if (method === 'Runtime.exceptionThrown')
      this.errors.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === 'Runtime.consoleAPICalled' && ['error', 'warning', 'assert'].includes(params.type))
      this.errors.push(params.args.map(arg => arg.value ?? arg.description).join(' '));
    if (method === 'Log.entryAdded' && params.entry.level === 'error')
      this.errors.push(params.entry.text);
    if (method === 'Network.requestWillBeSent' && /^(https?|wss?):/.test(params.request.url))
      this.requests.push(params.request.url);
  }

  call(method, params) { return this.browser.call(method, params, this.session); }

  async go(url) {
    await this.call('Network.enable');
    await this.call('Page.navigate', {url});
  }

  async close() { await this.browser.call('Target.closeTarget', {targetId: this.target}); }

  // The value of an expression in the page, also of one that has to be awaited.
  async value(expression) {
    const {result, exceptionDetails} =
      await this.call('Runtime.evaluate', {expression, returnByValue: true, awaitPromise: true});
    if (exceptionDetails)
      throw new Error(`${expression}: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
    return result.value;
  }

  // \throws after some seconds when an expression does not become true
  async until(expression, seconds = 40) {
    for (const end = Date.now() + 1000 * seconds; Date.now() < end; await pause(40))
      if (await this.value(expression).catch(() => false)) // there may be no document yet
        return;
    throw new Error(`is not so after ${seconds} s: ${expression}`);
  }

  async key(key) {
    const text = key.length === 1 ? key : undefined;
    const params = {key, text, windowsVirtualKeyCode: codes[key] ?? key.toUpperCase().charCodeAt(0)};
    await this.call('Input.dispatchKeyEvent', {type: text ? 'keyDown' : 'rawKeyDown', ...params});
    await this.call('Input.dispatchKeyEvent', {type: 'keyUp', ...params});
  }

  async move(x, y) { await this.call('Input.dispatchMouseEvent', {type: 'mouseMoved', x, y}); }

  async click(x, y) {
    await this.mouse('mousePressed', [x, y], 1);
    await this.mouse('mouseReleased', [x, y], 0);
  }

  async drag(from, to, steps = 6) {
    await this.mouse('mousePressed', from, 1);
    for (let i = 1; i <= steps; ++i)
      await this.mouse('mouseMoved', from.map((x, k) => x + (to[k] - x) * i / steps), 1);
    await this.mouse('mouseReleased', to, 0);
  }

  async mouse(type, [x, y], buttons) {
    await this.call('Input.dispatchMouseEvent', {type, x, y, button: 'left', buttons, clickCount: 1});
  }

  // Fingers from places to places; a tap if they stay.
  async touch(from, to = from, steps = 6) {
    const at = t => from.map(([x, y], i) => ({x: x + (to[i][0] - x) * t, y: y + (to[i][1] - y) * t, id: i}));
    await this.call('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: at(0)});
    for (let i = 1; from !== to && i <= steps; ++i)
      await this.call('Input.dispatchTouchEvent', {type: 'touchMove', touchPoints: at(i / steps)});
    await this.call('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
  }

  async press(selector) {
    await this.value(`document.querySelector(${JSON.stringify(selector)}).click()`);
  }

  // A PNG in base64.
  async picture() {
    const {data} = await this.call('Page.captureScreenshot', {format: 'png'});
    return data;
  }
}
