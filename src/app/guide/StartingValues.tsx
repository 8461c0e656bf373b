import type { Cycle } from "../../cycles/define.ts";
import { formatNumber } from "../../i18n/number.ts";
import { SPINDLE } from "../../report/advice/advise.ts";
import { useSettings } from "../settings/settings.ts";
import { takeValue, useTaking } from "./AdviceItems.tsx";
import { useAdviceTexts, useMaterialOfWork } from "./use-advice.ts";

/** Starting values of the material for the feeds of a cycle and for the speed: of one prompt, or of all. */
export function StartingValues({ cycle, only = null }: { readonly cycle: Cycle; readonly only?: string | null }) {
  const t = useAdviceTexts();
  const language = useSettings((s) => s.language);
  const { material } = useMaterialOfWork();
  const canTake = useTaking(cycle.number);
  const of = (shown: string) => Object.entries(cycle.params).find(([, param]) => param.shown === shown)?.[0];
  const rows = [{ at: SPINDLE, name: t.values.roughSpeed, value: material.roughSpeed, unit: t.units.speed }, {
    at: of("roughingFeed"),
    name: t.values.roughFeed,
    value: material.roughFeed,
    unit: t.units.feed,
  }, { at: of("finishingFeed"), name: t.values.finishFeed, value: material.finishFeed, unit: t.units.feed }].filter(({ at }) =>
    at !== undefined && (only === null || at === only)
  );
  if (rows.length === 0) return null;
  return (
    <section className="advice-starting" aria-label={t.starting}>
      <h2>{t.starting}</h2>
      <p className="soft">{material.name}, {t.groups[material.group]}. {t.startingLead}</p>
      <ul>
        {rows.map(({ at = "", name, value, unit }) => (
          <li key={name}>
            <span>{at !== SPINDLE && <b className="number">{at}</b>} {name}</span>
            <span className="number">{formatNumber(language, value)} {unit}</span>
            {canTake(at) && (
              <button type="button" className="button" aria-label={`${name}: ${t.take(formatNumber(language, value))}`} onClick={() =>
                takeValue(at, value)}
              >
                {t.take(formatNumber(language, value))}
              </button>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}
