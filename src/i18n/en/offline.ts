import type { Shape } from "../shape.ts";

export const offline = {
  install: {
    install: "Install",
    why: "Installed, Turnwise has a window of its own and an icon on this device.",
    byHand: "To install: Share, then Add to Home Screen.",
  },
  ready: "A newer version of Turnwise is ready.",
  updateNow: "Update now",
  later: "Later",
  elsewhere: "Turnwise was updated in another tab. This tab keeps its version.",
  reload: "Reload the page",
  look: "Check for updates",
  kept: {
    impossible: "This browser does not store the page for offline use; an https address is required.",
    coming: "Storing the page on this device for offline use …",
    kept: "Stored on this device: works offline.",
    failed: "The page is not fully stored on this device yet. The download continues when the network is back.",
  },
  looked: {
    no: "",
    looking: "Checking for updates …",
    coming: "Downloading a newer version …",
    newest: "This is the latest version.",
    unreachable: "The server does not respond. This version keeps working.",
    unfinished: "The newer version was not fully downloaded. This version stays in use.",
  },
};

export type OfflineTexts = Shape<typeof offline>;
