import type { ParamTextId } from "../../cycles/index.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { Param, Topic } from "../../cycles/params.ts";
import { formatNumber } from "../../i18n/number.ts";
import { CycleInWork } from "../../app/calculation/issue-text.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { unitOf } from "../../app/fields/dialog/write-value.ts";
import { applyValue, useCanApply } from "./apply-value.ts";
import { useTriedValues } from "./use-tried-values.ts";
import { ValueCard } from "./ValueCard.tsx";

/** The effect of a parameter at several values; a reserved one has none. */
export function ValuePictures({
  cycle,
  q,
  param,
}: {
  readonly cycle: Cycle;
  readonly q: string;
  readonly param: Param;
}) {
  const t = useTexts("guide");
  if (!param.reserved) return <TriedPictures cycle={cycle} q={q} param={param} />;
  return (
    <section className="guide-values" aria-label={t.values.title}>
      <h2>{t.values.title}</h2>
      <p className="soft">{t.values.reserved}</p>
    </section>
  );
}

/** A parameter at a small, a default and a large value, or at each of its choices, simulated. */
function TriedPictures({ cycle, q, param }: { readonly cycle: Cycle; readonly q: string; readonly param: Param }) {
  const t = useTexts("guide");
  const {
    dialog: { units },
    params,
  } = useTexts();
  const language = useSettings((s) => s.language);
  const { made: values, working } = useTriedValues(cycle, q);
  const canTake = useCanApply(cycle.number)(q) && values?.isOwn === true;
  const sizes = [t.values.small, t.values.usual, t.values.large];
  const needed = Object.entries(values?.needed ?? {})
    .map(([other, value]) => `${other} = ${formatNumber(language, value, cycle.params[other]?.decimals ?? 0)}`)
    .join(", ");
  const words = params[param.text as ParamTextId];
  const alike: Partial<Record<Topic, string>> = t.values.alike;
  const meanings: Readonly<Record<number, string>> = "choices" in words ? words.choices : {};
  return (
    <section className="guide-values" aria-label={t.values.title} aria-busy={working}>
      <h2>{t.values.title}</h2>
      <p className="soft">
        {values?.isOwn ? t.values.ownLead : t.values.lead}
        {needed && ` ${t.values.needed(needed)}`}
      </p>
      {values === undefined && (
        <p className="guide-working soft" role="status">
          {t.values.working}
        </p>
      )}
      {values === null && <p className="soft">{t.values.none}</p>}
      {values && (
        <CycleInWork value={cycle.number}>
          <ol className="value-cards">
            {values.tried.map((tried, i) => {
              const { value } = tried,
                isAuto = value === "auto";
              return (
                <ValueCard
                  key={String(value)}
                  tried={tried}
                  box={values.box}
                  letter={q}
                  text={isAuto ? "FAUTO" : formatNumber(language, value, param.decimals)}
                  unit={isAuto ? "" : units[unitOf(param, true)]}
                  meaning={isAuto ? undefined : meanings[value]}
                  size={param.choices || values.tried.length !== sizes.length ? null : (sizes[i] ?? null)}
                  whose={value !== values.standing ? null : values.isOwn ? t.values.yours : t.values.printed}
                  take={canTake && value !== values.standing ? () => void applyValue(cycle.number, q, value) : null}
                />
              );
            })}
          </ol>
          {values.tried.length === 1 && <p className="soft">{t.values.none}</p>}
          {values.tried.length > 1 && values.isUnseen && (
            <p className="soft">{alike[param.shown] ?? t.values.unseen}</p>
          )}
        </CycleInWork>
      )}
    </section>
  );
}
