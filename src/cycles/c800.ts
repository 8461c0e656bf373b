import { defineActing } from "./acting.ts";
import { partlyPrinted } from "./partly-printed.ts";
import { angle, choice, feedParam, recalled } from "./params.ts";

/** Fits the coordinate system of turning to a tilted or a rotated tool; with all angles 0 it changes nothing. */
export const c800 = defineActing({
  number: 800,
  evidence: "K1",
  partly: { section: "Cycle 800", document: "TNC7, 81762x-17", parts: ["name", "purpose"] },
  params: partlyPrinted(
    recalled({
      Q497: angle("precessionAngle", [0, 359.9999], 0),
      Q498: choice("reverseTool", [0, 1], 0),
      Q530: choice("inclinedMachining", [0, 1, 2, 3], 0),
      Q531: angle("incidenceAngle", [-180, 180], 0),
      Q532: feedParam("tiltingFeed", [0.001, 99999.999], 750, { perMinute: true }),
      Q533: choice("preferredDirection", [0, 1, 2, -2, -1], 0),
      Q535: choice("eccentricTurning", [0, 1, 2, 3], 3),
      Q536: choice("eccentricWithoutStop", [0, 1], 0),
    }),
    { Q497: "meaning", Q530: "values", Q531: "meaning" },
  ),
  // Q530 = 3 moves nothing, but the coordinate system still changes unless Q531 is 0.
  acts: { neutral: { Q497: [0], Q498: [0], Q531: [0], Q535: [0, 3] } },
});
