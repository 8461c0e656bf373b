import { cleanup, render, screen } from "@testing-library/react";
import { afterEach, beforeEach, expect, test } from "vitest";
import { catalogue } from "../../../cycles/index.ts";
import { at } from "../../../kernel/geometry/point.ts";
import { exampleJob } from "../../../program/job/job.ts";
import { setMeasured } from "../../document/edits.ts";
import { changeSettings } from "../../base/settings/settings.ts";
import { openFirstWork } from "../../document/store.ts";
import { MeasuredInSection } from "./Measurements.tsx";

const cycle = catalogue.find(({ number }) => number === 812);

beforeEach(() => {
  if (!cycle) throw new Error("no cycle 812");
  openFirstWork(exampleJob(cycle), "work");
  render(<MeasuredInSection />);
});
afterEach(cleanup);

test.each([
  ["en", /^Measured: 2\./],
  ["de", /^Gemessen: 2\./],
  ["fr", /^Mesures\s: 2\./],
  ["zh", /^测量结果：2。/],
] as const)(
  "over the 3D view a note in %s says how much was measured in the section, if anything",
  async (language, words) => {
    changeSettings({ language });
    expect(screen.queryByRole("status")).toBeNull();
    const place = { at: at(-13.7, 21.3), spot: "free" } as const;
    setMeasured(() => [
      { id: "1", plane: "ZX", kind: "diameter", places: [place] },
      { id: "2", plane: "XY", kind: "diameter", places: [place] },
      {
        id: "3",
        plane: "ZX",
        kind: "diameter",
        places: [place],
      },
    ]);
    expect((await screen.findByRole("status")).textContent).toMatch(words);
  },
);
