import { expectFine, expectFineInBothThemes } from "./layout-checks.ts";
import { test } from "./test.ts";

export const TABLET = { viewport: { width: 1024, height: 768 }, hasTouch: true };

/** Devices for `test.use`: as projects of their own they would start all workers and browsers again. */
const DEVICES = {
  desktop: {},
  tablet: TABLET,
  phone: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
} as const;

/** The same journeys on several devices. They are given the check of a screen, which looks at dark colours once. */
export function onDevices(
  names: readonly (keyof typeof DEVICES)[],
  journeys: (expectFineHere: typeof expectFine) => void,
): void {
  for (const name of names)
    test.describe(name, () => {
      test.use(DEVICES[name]);
      journeys(name === "desktop" ? expectFineInBothThemes : expectFine);
    });
}
