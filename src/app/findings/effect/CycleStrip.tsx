import type { JobReading } from "../../document/reading.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { areaDecimals } from "./changes.ts";
import { chipArea, cutAtOnce } from "./effect.ts";
import { EffectStrip, useEffectCells } from "./EffectStrip.tsx";

/** The strip of one cycle: also its actual infeed and its chip. */
export function CycleStrip({ read }: { readonly read: JobReading }) {
  const t = useTexts().page.effect;
  const { shown, effect, number, cells } = useEffectCells();
  // A thread has no chip of one size: it changes from pass to pass.
  const cuts = read.cycle.group !== "thread";
  const chip = shown && chipArea(read, cutAtOnce(shown));
  return (
    <EffectStrip
      name={t.title}
      cells={[
        cells.passes,
        { name: t.infeed, value: number(effect?.infeed, 3), unit: "mm", compared: "infeed" },
        cells.time,
        ...(cuts
          ? [
              {
                name: t.chip,
                value: number(chip, areaDecimals(chip ?? 0)),
                unit: "mm²",
                compared: "chip",
                isLeast: true,
              } as const,
            ]
          : []),
        cells.residual,
      ]}
      waiting={t.waiting}
    />
  );
}
