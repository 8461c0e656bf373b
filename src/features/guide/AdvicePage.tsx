import { cycleByNumber } from "../../cycles/index.ts";
import { changeSettings, useSettings } from "../../app/base/settings/settings.ts";
import { useEditor } from "../../app/document/store.ts";
import { AdviceItems } from "./AdviceItems.tsx";
import { CuttingDataTable } from "./CuttingDataTable.tsx";
import { MaterialChoice } from "./MaterialChoice.tsx";
import { StartingValues } from "./StartingValues.tsx";
import { useAdvisedCalls } from "../../app/fields/said/use-advice.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

/** All advice on the open work, its material, and the cutting data behind it. */
export function AdvicePage() {
  const t = useTexts("advice");
  const calls = useAdvisedCalls();
  const on = useSettings((s) => s.advice);
  const isOpen = useEditor((s) => s.work !== null);
  const job = useEditor((s) => s.job);
  const cycle = job && cycleByNumber(job.cycle);
  const said = calls.filter(({ advice }) => advice.length > 0);
  return (
    <>
      <header className="guide-head">
        <h1>{t.title}</h1>
        <p>{t.lead}</p>
        <label className="advice-switch">
          <input
            type="checkbox"
            checked={on}
            onChange={(event) => changeSettings({ advice: event.currentTarget.checked })}
          />
          <span>{t.show}</span>
        </label>
      </header>
      <MaterialChoice />
      {on &&
        said.map(({ operation, cycle: number, advice }) => (
          <section key={operation} aria-label={t.operation(operation + 1, number)}>
            <h2>{t.operation(operation + 1, number)}</h2>
            <AdviceItems cycle={number} advice={advice} />
          </section>
        ))}
      {on && said.length === 0 && <p className="soft">{isOpen ? t.none : t.nothingOpen}</p>}
      {cycle && !cycle.acts && <StartingValues cycle={cycle} />}
      <CuttingDataTable />
    </>
  );
}
