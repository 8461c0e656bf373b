import type { Cycle } from "../../cycles/define.ts";
import { isRecalled } from "../../cycles/params.ts";
import type { CycleNumber, ParamTextId } from "../../cycles/index.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { GlossaryText, GlossaryList, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";
import { showGuide } from "../../app/place/place.ts";
import { StepPlayer, WaitingSteps } from "./StepPlayer.tsx";
import { useCycleRun } from "./use-cycle-run.ts";

/** The numbered steps of a cycle as they run. */
function CycleSteps({ cycle }: { readonly cycle: Cycle }) {
  const t = useTexts("guide");
  const run = useCycleRun(cycle);
  return (
    <section className="guide-steps">
      <h2>{t.steps.title}</h2>
      <p className="soft">{t.steps.lead}</p>
      {run === undefined && (
        <>
          <p className="unseen" role="status">
            {t.values.working}
          </p>
          <WaitingSteps cycle={cycle} />
        </>
      )}
      {run === null && <p className="soft">{t.values.none}</p>}
      {run && <StepPlayer cycle={cycle} run={run} />}
    </section>
  );
}

/** The page of a cycle: its purpose, its steps as they run, and the links to its parameters. */
export function CyclePage({ cycle }: { readonly cycle: Cycle }) {
  const t = useTexts("guide");
  const { cycles, dialog, params } = useTexts();
  const words = cycles.of[cycle.number as CycleNumber];
  return (
    <GlossaryScope texts={[...words.description, ...words.notes]}>
      <header className="guide-head">
        <h1>
          <span className="number prompt-q">{cycle.number}</span> {words.name}
        </h1>
        {words.description.map((sentence) => (
          <p key={sentence}>
            <GlossaryText text={sentence} />
          </p>
        ))}
        {isRecalled(cycle) && <p className="soft small">{dialog.recalled}</p>}
      </header>
      {!cycle.acts && <CycleSteps cycle={cycle} />}
      {Object.keys(cycle.params).length > 0 && (
        <section aria-label={t.parameters}>
          <h2>{t.parameters}</h2>
          <ul className="guide-links">
            {Object.entries(cycle.params).map(([q, { text }]) => (
              <li key={q}>
                <button
                  type="button"
                  className="guide-link"
                  onClick={() => showGuide("guide", String(cycle.number), q)}
                >
                  <b className="number">{q}</b> {params[text as ParamTextId].label}
                </button>
              </li>
            ))}
          </ul>
        </section>
      )}
      {words.notes.length > 0 && <GlossaryList texts={words.notes} className="guide-notes soft" />}
    </GlossaryScope>
  );
}
