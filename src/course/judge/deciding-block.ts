import { at } from "../../kernel/geometry/point.ts";
import { producedParts } from "../../sim/produced-parts.ts";
import type { Prediction } from "../task.ts";
import { firstStepInto } from "./difference.ts";
import type { Answer } from "./judgement.ts";
import { roughingPasses } from "./rules.ts";
import { sizeOn } from "./sizes.ts";

/** Width of the strip on a surface in which its last cut is found, mm. */
const STRIP = 0.05;

/** The block that decides the answer to a question; null where none alone does. */
export function decidingBlock(prediction: Prediction, { run, simulation, text }: Answer): number | null {
  const definition = (index: number | undefined) => run.operations[index ?? -1]?.definedIn ?? null;
  switch (prediction.ask) {
    case "diameter":
    case "bore":
    case "face": {
      const found = sizeOn(producedParts(simulation), prediction.ask, prediction.at);
      if (!found) return null;
      const { z, r } = found.place;
      const [left, right, low, high] = {
        face: [z, z + STRIP, r - STRIP, r + STRIP] as const,
        diameter: [z - STRIP, z + STRIP, r, r + STRIP] as const,
        bore: [z - STRIP, z + STRIP, r - STRIP, r] as const,
      }[prediction.ask];
      const strip = [at(left, low), at(right, low), at(right, high), at(left, high)];
      const { block = null, operation } = firstStepInto([strip], { run, simulation, text });
      return definition(operation) ?? block;
    }
    case "passes":
    case "infeed":
    case "seconds": {
      const { operation } = prediction;
      if (operation !== undefined) return definition(operation);
      const roughing = run.operations.flatMap((each, i) => (roughingPasses(each) > 0 ? [i] : []));
      return roughing.length === 1 ? definition(roughing[0]) : null;
    }
    case "residue":
    case "residuePlace": {
      const [greatest] = simulation.proof.residual.toSorted((a, b) => b.area - a.area);
      return greatest ? definition(greatest.operation) : null;
    }
    case "rapidPlace":
      return simulation.findings.find(({ kind }) => kind === "rapidInStock")?.block ?? null;
    default:
      return null;
  }
}
