import { useTexts } from "../base/settings/use-texts.ts";
import type { TaskResult } from "./task-result.ts";

/** The failed goals of the last check of an exercise, each a row that leads to its place. */
export function TaskRows({
  task: { title, rows, heldBack },
  chosen,
}: {
  readonly task: TaskResult;
  readonly chosen: string | null;
}) {
  const { findings: t } = useTexts();
  return (
    <>
      {rows.length > 0 && (
        <section className="findings-task" aria-label={title}>
          <h3>{title}</h3>
          <ul>
            {rows.map(({ id, mark, kind, text, go }) => (
              <li key={id} className={`finding leads on-${kind}`} aria-current={id === chosen ? "true" : undefined}>
                <span className={`badge badge-${kind}`} aria-hidden="true">
                  {mark}
                </span>
                <div>
                  <p>
                    <button type="button" className="finding-go" aria-label={`${t.show(mark)}: ${text}`} onClick={go}>
                      {text}
                    </button>
                  </p>
                </div>
              </li>
            ))}
          </ul>
        </section>
      )}
      {heldBack !== null && <p className="small soft">{heldBack}</p>}
    </>
  );
}
