import { readJob } from "../reading.ts";
import { useEditor } from "../store.ts";
import { goTo } from "../dialog/prompts.ts";
import type { ParamTextId } from "../../cycles/index.ts";
import { Icon } from "../Icon.tsx";
import { useIssueText } from "../issue-text.ts";
import { goToField, showSection } from "../place.ts";
import { isAboutTool, useProblems, type Problem } from "./problems.ts";
import { useTexts } from "../settings/use-texts.ts";

interface Target {
  readonly name: string;
  readonly go: () => void;
}

/** Where a finding belongs to, and how to get there. */
function useTarget(): (problem: Problem) => Target | null {
  const t = useTexts();
  const job = useEditor((s) => s.job);
  const read = job && readJob(job);
  return ({ issue, at, block }) => {
    const param = at === null ? undefined : read?.cycle.params[at];
    const places = t.page.problem.places;
    if (at !== null && param) return { name: t.dialog.value(at, t.params[param.text as ParamTextId].label), go: () => goTo(at) };
    if (at === "start.x") return { name: places.startX, go: () => goToField("setup", "start.x") };
    if (at === "start.z") return { name: places.startZ, go: () => goToField("setup", "start.z") };
    if (at === "contour") return { name: places.contour, go: () => showSection("contour") };
    if (issue.code === "blankMissing" || issue.code === "blankImpossible") return { name: places.blank, go: () => goToField("setup", "blank.outside") };
    if (issue.code === "spindleMissing") return { name: places.spindle, go: () => goToField("setup", job?.spindle.mode === "constant" ? "spindle.speed" : "spindle.cuttingSpeed") };
    if (isAboutTool(at)) return { name: places.tool, go: () => goToField("setup", "tool") };
    if (block !== null) return { name: t.page.problem.inBlock(block), go: () => showSection("program") };
    return null;
  };
}

/** All findings, worst first, each with a way to its place. */
export function ProblemList() {
  const t = useTexts().page.problem;
  const say = useIssueText();
  const targetOf = useTarget();
  const problems = useProblems();
  if (problems.length === 0) return <p className="no-problems"><Icon name="check" /> {t.none}</p>;
  return (
    <ul className="problem-list">
      {problems.map((problem, i) => {
        const { issue, block } = problem;
        const target = targetOf(problem);
        return (
          <li key={i} className={`problem ${issue.severity}`}>
            <Icon name={issue.severity} />
            <div>
              <p className="small problem-head">
                <b>{t.severities[issue.severity]}</b>
                {target && <span> · {target.name}</span>}
                {block !== null && target?.name !== t.inBlock(block) && <span className="soft"> · {t.inBlock(block)}</span>}
              </p>
              <p>{say(issue)}</p>
              {target && <button type="button" className="button small" onClick={target.go}>{t.goTo(target.name)}</button>}
            </div>
          </li>
        );
      })}
    </ul>
  );
}
