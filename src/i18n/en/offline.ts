import type { Shape } from "../shape.ts";

export const offline = {
  ready: "A newer version of Turnwise is ready.",
  updateNow: "Update now",
  later: "Later",
  elsewhere: "Turnwise was updated in another tab. This one goes on with the version it began with.",
  reload: "Load the page again",
  look: "Look for a newer version",
  kept: {
    impossible: "This browser does not keep the page for use without a network; that needs an address with https.",
    coming: "The page is being kept on this device, for use without a network.",
    kept: "Kept on this device: works without a network.",
    failed: "The page is not yet whole on this device. That goes on as soon as there is a network.",
  },
  looked: {
    no: "",
    looking: "Looking for a newer version.",
    coming: "A newer version is being fetched.",
    newest: "This is the newest version.",
    unreachable: "The server does not answer. What is here goes on working.",
    unfinished: "The newer version did not arrive whole. This one stays in use.",
  },
};

export type OfflineTexts = Shape<typeof offline>;
