import { defineConfig, devices } from "@playwright/test";
import { browserFlags, findLightBrowser } from "./scripts/browser.mjs";

/** Journeys run on the built page, as it is served to users. `npm run e2e` builds first. */
const port = Number(process.env["PORT"] ?? 4179);
const executablePath = process.env["CHROMIUM_PATH"] ?? findLightBrowser();
/**
 * A journey ends before what the last and slowest of the compilers makes pays for itself: a tenth less work. The one
 * before it compiles only what runs ten times as often as it would wait for otherwise: another twelfth. The stack is a
 * seventh of the usual one, kB: a call with a list as its arguments, which overflows it in long programs, does so in
 * shorter ones.
 */
const V8_FLAGS = `--js-flags=${[
  "--no-turbofan",
  "--invocation-count-for-maglev=3000",
  "--interrupt-budget-for-maglev=400000",
  "--stack-size=150",
].join()}`;
const launchOptions = { args: [...browserFlags, V8_FLAGS], ...(executablePath ? { executablePath } : {}) };

/**
 * Room for a machine many times slower than this and busy: a limit is for what never comes, not for what comes late,
 * ms.
 */
const PATIENCE = { journey: 300_000, step: 90_000 };

/** Journeys about what the browser fetches and caches: each has a context that has never been used. */
const FIRST_VISITS = /\/(load|offline)\.spec\.ts/;
const desktop = { ...devices["Desktop Chrome"], viewport: { width: 1280, height: 800 } };

export default defineConfig({
  testDir: "e2e",
  snapshotPathTemplate: "{testDir}/{arg}{ext}",
  outputDir: "test-results",
  fullyParallel: true,
  // Two for each core of a small machine: a journey waits for half of its time, for its page or for the page's timers.
  workers: 4,
  retries: process.env["CI"] ? 1 : 0,
  forbidOnly: Boolean(process.env["CI"]),
  timeout: PATIENCE.journey,
  expect: { timeout: PATIENCE.step },
  reporter: process.env["PLAYWRIGHT_JSON_OUTPUT_FILE"] ? [["list"], ["json"]] : [["list"]],
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    launchOptions,
    actionTimeout: PATIENCE.step,
    navigationTimeout: PATIENCE.step,
    trace: "off",
    // A context that is emptied between journeys keeps compiled code: a seventh less work than a new one for each.
    reuseContext: true,
    permissions: ["clipboard-read", "clipboard-write"],
    // Journeys about motion ask for it; in the others the lathe of the start page would play as long as they wait.
    reducedMotion: "reduce",
    // Only the journeys without a network keep the page; the others would fetch all of it every time.
    serviceWorkers: "block",
  },
  webServer: {
    command: `node e2e/serve.mjs ${port}`,
    port,
    reuseExistingServer: false,
    stdout: "ignore",
    stderr: "pipe",
  },
  // Each project starts workers and browsers of its own. The one with few long journeys comes first: at the end, one of
  // them would keep one core waiting.
  projects: [
    {
      name: "first visit",
      testMatch: FIRST_VISITS,
      // Two of the four: a worker that goes on with the other journeys would be started again for them.
      workers: 2,
      use: { ...desktop, reuseContext: false },
    },
    {
      name: "desktop",
      testIgnore: FIRST_VISITS,
      use: { ...desktop },
    },
  ],
});
