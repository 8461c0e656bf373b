import type { Cycle } from "../../cycles/define.ts";
import { formatNumber } from "../../i18n/number.ts";
import { SPINDLE } from "../../report/advice/advise.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { startingValues } from "./starting.ts";
import { StartingRows } from "./StartingRows.tsx";
import { useGuidedCut, useMaterialOfWork } from "../../app/fields/said/use-advice.ts";
import "./setup-start.css";
import { useTexts } from "../../app/base/settings/use-texts.ts";

interface Props {
  readonly cycle: Cycle;
  /** The spindle keeps the cutting speed: a speed can be applied. */
  readonly surface: boolean;
  /** Feeds are per revolution, as the starting values are. */
  readonly perRevolution: boolean;
}

/** The starting values of the work's material, below the speed of the set-up. */
export function SetupStart({ cycle, surface, perRevolution }: Props) {
  const t = useTexts("advice");
  const language = useSettings((s) => s.language);
  const on = useSettings((s) => s.advice);
  const own = useSettings((s) => s.cutting !== "");
  const { material } = useMaterialOfWork();
  const cut = useGuidedCut(cycle.number);
  if (!on) return null;
  const isFeed = (at: string) => cycle.params[at]?.kind === "feed";
  const rows = startingValues(cycle, material, cut).filter(({ at }) =>
    at === SPINDLE ? surface : perRevolution && isFeed(at),
  );
  const speeds = [material.roughSpeed, material.finishSpeed].map((speed) => formatNumber(language, speed)).join("–");
  return (
    <section className="setup-start" aria-label={t.starting}>
      <p>
        {t.start(`${material.name}, ${t.groups[material.group]}`, `${speeds} ${t.units.speed}`)}{" "}
        <span className="soft">{own ? t.startOwn : t.startSource}</span>
      </p>
      <StartingRows cycle={cycle.number} rows={rows} />
    </section>
  );
}
