import type { Cycle } from "../../cycles/define.ts";
import { startingValues } from "./starting.ts";
import { StartingRows } from "./StartingRows.tsx";
import { useGuidedCut, useMaterialOfWork } from "../../app/fields/said/use-advice.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** Starting values of a cycle for the material and the tool of the work: of one prompt, or of all; nothing if there is none. */
export function StartingValues({ cycle, only = null }: { readonly cycle: Cycle; readonly only?: string | null }) {
  const t = useTexts("advice");
  const { material } = useMaterialOfWork();
  const cut = useGuidedCut(cycle.number);
  const rows = startingValues(cycle, material, cut).filter(({ at }) => only === null || at === only);
  if (rows.length === 0) return null;
  return (
    <section className="advice-starting" aria-label={t.starting}>
      <h2>{t.starting}</h2>
      <p className="soft">
        {material.name}, {t.groups[material.group]}. {t.startingLead}
      </p>
      <StartingRows cycle={cycle.number} rows={rows} />
    </section>
  );
}
