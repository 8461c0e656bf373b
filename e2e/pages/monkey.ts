import type { CDPSession, Page } from "@playwright/test";
import { LANGUAGES, type Language } from "../../src/i18n/languages.ts";
import { settle, shownFaults, takeTarget, type Target } from "./monkey-page.ts";
import { isPolicyMessage, onBlocked } from "./policy.ts";
import { Turnwise } from "./turnwise.ts";

/** A window of the monkey, px. */
export interface Size {
  readonly width: number;
  readonly height: number;
  readonly touch: boolean;
}

const SIZES: readonly Size[] = [
  { width: 1280, height: 800, touch: false },
  { width: 390, height: 664, touch: true },
  { width: 1440, height: 900, touch: false },
  { width: 768, height: 1024, touch: true },
  { width: 1024, height: 768, touch: false },
];
/** Every language in every size once, each step another language and another size. */
export const WORLDS: readonly (readonly [Language, Size])[] = LANGUAGES.flatMap((_, turn) =>
  SIZES.map((size, i) => [LANGUAGES[(i + turn) % LANGUAGES.length] ?? "en", size] as const),
);

const PLACES = ["", "which", "works", "tools", "tools/milling", "own", "plan", "course", "course/first-shoulder"];
const GUIDES = ["guide/812", "guide/860/Q463", "glossary", "course/first-shoulder/tasks"];
const TYPED = ["0", "-1", "12.5", "1/3", "2,4*3", "99999999", "=1+1", "<b>x", "ROUGH Ä", "中", "L X+20 Z-5", "", " "];
const KEYS = ["Escape", "Enter", "Tab", "Shift+Tab", "ArrowDown", "ArrowUp", "End", "Home", "Delete", "Control+z"];
const MORE_KEYS = [
  "Control+y",
  "PageDown",
  "PageUp",
  "ArrowLeft",
  "ArrowRight",
  "Space",
  "F2",
  "Control+f",
  "Backspace",
];
/** Actions before a finding that are kept with it. */
const STEPS = 14;

/** Something that must not happen, and the actions that led to it, the last one last. */
export interface Finding {
  readonly what: string;
  readonly steps: readonly string[];
}

/** Random numbers of a seed, from 0 up to 1 (mulberry32). */
function randomOf(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Presses whatever can be pressed, in an order that a seed decides, and notes what must not happen. */
export class Monkey {
  readonly findings: Finding[] = [];
  private readonly random: () => number;
  private readonly steps: string[] = [];
  private readonly pressed: Record<string, number> = {};
  private touch = false;

  private constructor(
    private readonly page: Page,
    private readonly devtools: CDPSession,
    seed: number,
  ) {
    this.random = randomOf(seed);
  }

  /** A monkey on the start page. Nothing leaves the page: downloads, files to choose and other windows end here. */
  static async on(page: Page, seed: number): Promise<Monkey> {
    const monkey = new Monkey(page, await page.context().newCDPSession(page), seed);
    page.on("console", (line) => {
      if (line.type() === "error" && !isPolicyMessage(line.text())) monkey.note(`console: ${line.text()}`);
    });
    await onBlocked(page, (what) => monkey.note(what));
    page.on("pageerror", (error) => monkey.note(`error: ${error.stack ?? error.message}`));
    page.on("dialog", (dialog) => void dialog.accept().catch(() => undefined));
    page.on("download", (download) => void download.cancel().catch(() => undefined));
    page.on("filechooser", () => undefined);
    page.context().on("page", (other) => void other.close());
    await page.addInitScript(() => {
      window.print = () => undefined;
      window.addEventListener("unhandledrejection", ({ reason }) => console.error("unhandled rejection", reason));
    });
    await page.goto("./");
    return monkey;
  }

  private note(what: string): void {
    this.findings.push({ what, steps: this.steps.slice(-STEPS) });
    if (process.env["MONKEY_PRESSES"])
      console.log(`press ${this.steps.length}: ${what}\n  ${this.steps.slice(-STEPS).join("\n  ")}`);
  }

  private one<T>(all: readonly T[]): T {
    return all[Math.floor(this.random() * all.length)] as T;
  }

  /** Changes the window and, through the settings, the language. */
  async enter(language: Language, { width, height, touch }: Size): Promise<void> {
    const { page } = this;
    this.steps.push(`window ${width}x${height}${touch ? " touch" : ""}, ${language}`);
    await page.setViewportSize({ width, height });
    await this.devtools.send("Emulation.setTouchEmulationEnabled", {
      enabled: touch,
      ...(touch && { maxTouchPoints: 1 }),
    });
    this.touch = touch;
    await this.home();
    const tag = await page.evaluate(() => document.documentElement.lang);
    const shown = LANGUAGES.find((each) => tag.startsWith(each)) ?? "en";
    if (shown !== language) await Turnwise.at(page, shown).settings.chooseLanguage(language);
  }

  /** The start page with nothing open above it. */
  private async home(): Promise<void> {
    const { page } = this;
    await page.goto("./#/");
    await page.locator("main.start-page").waitFor();
    // A dialog that was asked for last may still be fetched.
    await page.waitForLoadState("networkidle");
    for (let i = 0; i < 4 && (await page.locator("dialog[open], [role=menu]").count()) > 0; i += 1) {
      await page.keyboard.press("Escape");
      await settle(page, false);
    }
    await settle(page, false);
  }

  /** One random action and a look at the page after it. */
  async press(): Promise<void> {
    try {
      const isKeyed = await this.act(this.random());
      await this.look(isKeyed);
    } catch (error) {
      // The press has reloaded the page, or gone to another one.
      if (!/context was destroyed|navigat|detached/i.test(String(error))) throw error;
      await this.page.waitForLoadState();
    }
    if (!this.page.url().includes("#/") && !/\/(?:\?.*)?$/.test(this.page.url())) await this.page.goto("./#/");
  }

  /** Returns what had the focus, if a key may have moved it; null after a press by mouse or finger. */
  private async act(chance: number): Promise<string | null> {
    const { page } = this;
    const { keyboard, mouse } = page;
    if (chance < 0.04) return this.go(`./#/${this.one([...PLACES, ...GUIDES])}`);
    if (chance < 0.06) {
      this.steps.push("back");
      await page.goBack({ waitUntil: "commit" }).catch(() => undefined);
      return null;
    }
    if (chance < 0.09) return this.drag();
    if (chance < 0.19) {
      const key = this.one(this.random() < 0.6 ? KEYS : MORE_KEYS);
      const before = await settle(page, false);
      this.steps.push(`key ${key} on ${before}`);
      await keyboard.press(key);
      // Tab may leave the page for the browser's own bar.
      return key.endsWith("Tab") ? null : before;
    }
    const isTyping = chance < 0.34;
    const target = await takeTarget(page, { isTyping, rolls: [this.random(), this.random()], pressed: this.pressed });
    if (!target) return this.go("./#/");
    this.pressed[target.kind] = (this.pressed[target.kind] ?? 0) + 1;
    if (target.options.length > 0) {
      const option = this.one(target.options);
      this.steps.push(`choose ${option} in ${target.what}`);
      await page
        .locator("[data-monkey]")
        .selectOption(option, { timeout: 1000 })
        .catch(() => undefined);
      return null;
    }
    if (isTyping && target.isField) {
      const text = this.one(TYPED);
      const key = this.one(["Enter", "Tab", "Escape", "Control+z", ""]);
      this.steps.push(`type ${JSON.stringify(text)} ${key} in ${target.what}`);
      await this.hit(target);
      await keyboard.press("Control+a");
      await keyboard.insertText(text);
      const before = await settle(page, false);
      if (key !== "") await keyboard.press(key);
      return key === "Tab" ? null : before;
    }
    if (!this.touch && this.random() < 0.35 && target.isFocusable) {
      const key = this.random() < 0.7 ? "Enter" : "Space";
      this.steps.push(`${key} on ${target.what}`);
      await page
        .locator("[data-monkey]")
        .focus({ timeout: 1000 })
        .catch(() => undefined);
      const before = await settle(page, false);
      await keyboard.press(key);
      return before;
    }
    this.steps.push(`${this.touch ? "tap" : "click"} ${target.what}`);
    await this.hit(target);
    await mouse.move(target.x + 1, target.y);
    return null;
  }

  private async go(address: string): Promise<null> {
    this.steps.push(`go to ${address}`);
    await this.page.goto(address, { waitUntil: "commit" }).catch(() => undefined);
    return null;
  }

  private async hit({ x, y }: Pick<Target, "x" | "y">): Promise<void> {
    if (!this.touch) return this.page.mouse.click(x, y);
    const touchPoints = [{ x, y }];
    await this.devtools.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints });
    await this.devtools.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  }

  private async drag(): Promise<null> {
    const { width, height } = this.page.viewportSize() ?? { width: 0, height: 0 };
    const { mouse } = this.page;
    const [a, b, c, d] = [this.random() * width, this.random() * height, this.random() * width, this.random() * height];
    this.steps.push(`drag ${[a, b, c, d].map(Math.round).join(" ")}`);
    await mouse.move(a, b);
    await mouse.down();
    await mouse.move(c, d, { steps: 3 });
    await mouse.up();
    if (this.random() < 0.5) await mouse.wheel(0, this.random() * 800 - 400);
    return null;
  }

  private async look(before: string | null): Promise<void> {
    const now = await settle(this.page, before !== null && before !== "body");
    if (before !== null && before !== "body" && now === "body") this.note(`lost focus: it was on ${before}`);
    for (const fault of await shownFaults(this.page)) {
      this.note(fault);
      if (process.env["MONKEY_PRESSES"])
        await this.page.screenshot({ path: `test-results/monkey-${this.steps.length}.png` });
      await this.page.goto("./#/");
      await this.page.reload();
    }
  }

  /** What the page holds on the start page after a garbage collection. */
  async held(): Promise<{ readonly megabytes: number; readonly nodes: number; readonly listeners: number }> {
    await this.home();
    for (let i = 0; i < 3; i += 1) await this.devtools.send("HeapProfiler.collectGarbage");
    const { nodes, jsEventListeners: listeners } = await this.devtools.send("Memory.getDOMCounters");
    const { usedSize } = await this.devtools.send("Runtime.getHeapUsage");
    return { megabytes: Math.round(usedSize / 1e5) / 10, nodes, listeners };
  }
}
