import { useId } from "react";
import type { ThreadRoles } from "../../../cycles/define.ts";
import { depthForNose, sideOf, valuesOfThread, type ThreadAim } from "../../../cycles/thread-values.ts";
import { noseRadius, pointAngle } from "../../../kernel/cutter/insert.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { designationOf, type Aim, type NamedThread } from "../../../kernel/thread/named-thread.ts";
import { standardOf } from "../../../kernel/thread/threads.ts";
import { hasAngleOf } from "../../../program/tools/thread-tool.ts";
import { Message } from "../../base/Message.tsx";
import { useTexts } from "../../base/settings/use-texts.ts";
import { useToolList } from "../../document/work-tools.ts";
import type { JobReading } from "../../document/reading.ts";
import { addThreadTool, blankOfThread } from "./thread-blank.ts";
import { useThreadNumbers } from "./thread-numbers.ts";

interface Props {
  readonly thread: NamedThread;
  readonly read: JobReading;
  readonly roles: ThreadRoles;
  readonly tool: Tool | null;
  readonly how: ThreadAim;
  /** Calls another tool for the thread. */
  readonly takeTool: ((T: number) => void) | undefined;
}

/** Smaller errors of the pitch diameter are not worth a correction, mm. */
const LEAST_ERROR = 0.01;
/** Tip orientations that cut outside, and inside. */
const SIDES: Readonly<Record<"outside" | "inside", readonly number[]>> = { outside: [1, 2, 3], inside: [5, 6, 7] };

/** Error of the pitch diameter by the nose radius of a fitting insert, mm; 0 where none is known. */
function errorByNose(thread: NamedThread, inside: boolean, tool: Tool | null): number {
  if (!tool || !hasAngleOf(thread, tool)) return 0;
  const off = depthForNose(thread, inside, noseRadius(tool)) * 2;
  return Math.abs(off) < LEAST_ERROR ? 0 : off;
}

/** The values that a thread puts into the prompts, where they change, and what it asks of shaft, bore and insert. */
export function ThreadProposal({
  onAim,
  onNose,
  onFill,
  ...props
}: Props & {
  /** A job has a blank, which gets the diameter before the thread. */
  readonly isJob: boolean;
  readonly onAim: (aim: Aim) => void;
  readonly onNose: (byNose: boolean) => void;
  readonly onFill: () => void;
}) {
  const { thread, read, roles, tool, how } = props;
  const t = useTexts("threads");
  const numbers = useThreadNumbers(read);
  const id = useId();
  const { partial } = read.reading;
  const side = sideOf(thread, roles, partial);
  const name = numbers.name(designationOf(thread, side));
  const fill = valuesOfThread(thread, roles, partial, how);
  if (typeof fill === "string")
    return (
      <Message tone="warning">{fill === "taper" ? t.taper : t.side[thread.outside ? "outside" : "inside"]}</Message>
    );
  const tolerance = thread[side]?.tolerance;
  const blank = props.isJob ? read.job.blank : null;
  const ofBlank = blankOfThread(fill);
  const off = errorByNose(thread, fill.inside, tool);
  return (
    <div className="thread-proposal" role="group" aria-label={t.proposal(name)}>
      <div className="thread-head">
        <strong>{name}</strong>
        {tolerance && (
          <select
            className="select"
            aria-label={t.aim}
            value={how.aim}
            onChange={(event) => onAim(event.target.value === "basic" ? "basic" : "middle")}
          >
            <option value="middle">{t.middle(tolerance.name)}</option>
            <option value="basic">{t.basic}</option>
          </select>
        )}
        <button type="button" className="button primary" onClick={onFill}>
          {t.fill}
        </button>
      </div>
      <ul className="thread-values">
        {Object.entries(fill.values).map(([q, value]) => {
          const now = partial[q];
          const isOther = typeof now === "number" && numbers.at(q, now) !== numbers.at(q, value);
          return (
            <li key={q}>
              <span className="soft">{q}</span> <span className="number">{numbers.at(q, value)}</span>
              {isOther && <span className="small soft"> ({t.instead(numbers.at(q, now))})</span>}
            </li>
          );
        })}
        {blank && (
          <li>
            <span className="soft">{t.blank[ofBlank.place]}</span>{" "}
            <span className="number">{numbers.length(ofBlank.size)}</span>
            {Number(blank[ofBlank.place]) !== ofBlank.size && (
              <span className="small soft"> ({t.instead(blank[ofBlank.place])})</span>
            )}
          </li>
        )}
      </ul>
      {tool && (off !== 0 || how.nose !== null) && (
        <label className="thread-nose small" htmlFor={id}>
          <input
            id={id}
            type="checkbox"
            checked={how.nose !== null}
            onChange={(event) => onNose(event.target.checked)}
          />
          <span>
            {t.nose(numbers.length(noseRadius(tool)))}.{" "}
            {t.noseAbout(numbers.plain(tool.T), numbers.length(Math.abs(off)))}
          </span>
        </label>
      )}
      <ThreadFacts {...props} />
    </div>
  );
}

/** Shaft or bore before the thread, its pitch diameter, the insert it needs, and where the figures are from. */
export function ThreadFacts({ thread, read, roles, tool, how, takeTool, short }: Props & { readonly short?: boolean }) {
  const t = useTexts("threads");
  const numbers = useThreadNumbers(read);
  const tools = useToolList();
  const fill = valuesOfThread(thread, roles, read.reading.partial, how);
  if (typeof fill === "string") return null;
  const side = fill.inside ? "inside" : "outside";
  const { tolerance } = thread[side] ?? {};
  const { documents } = standardOf(thread);
  const limits = tolerance && ` (${t.limits(numbers.length(tolerance.crest[0]), numbers.length(tolerance.crest[1]))})`;
  const onPitch = tolerance && ` (${t.limits(numbers.length(tolerance.pitch[0]), numbers.length(tolerance.pitch[1]))})`;
  const isUnfit = tool !== null && !hasAngleOf(thread, tool);
  const suitable = tools.find((other) => hasAngleOf(thread, other) && SIDES[side].includes(other.TO))?.T;
  return (
    <div className="thread-facts small">
      <p>
        {thread.taper > 0 ? (
          t.beforeTaper
        ) : (
          <>
            {t.before[side]} <b className="number">{numbers.length(fill.cut.crest)}</b>
            {limits}
          </>
        )}
        {thread.taper === 0 && (
          <>
            {" · "}
            {t.pitchDiameter} <span className="number">{numbers.length(fill.cut.pitch)}</span>
            {onPitch}
          </>
        )}
        {" · "}
        {t.angle}{" "}
        {thread.flanks
          ? t.flanks(numbers.plain(thread.angle), numbers.plain(thread.flanks[0]), numbers.plain(thread.flanks[1]))
          : t.angleOf(numbers.plain(thread.angle))}
      </p>
      {isUnfit && (
        <Message tone="warning" as="div" className="thread-note">
          <div>
            <p>{t.noInsert(numbers.plain(tool.T), numbers.plain(pointAngle(tool)), numbers.plain(thread.angle))}</p>
            <button
              type="button"
              className="button small"
              onClick={() => takeTool?.(suitable ?? addThreadTool(thread, fill))}
            >
              {suitable === undefined ? t.addTool(numbers.plain(thread.angle)) : t.useTool(numbers.plain(suitable))}
            </button>
          </div>
        </Message>
      )}
      <p className="soft">
        {[
          !short && !thread.listed && t.unlisted(documents),
          !tolerance && thread.taper === 0 && t.noTolerance,
          thread.leftHand && t.leftHand,
          thread.flanks && t.asymmetric,
          !short && t.source(documents),
        ]
          .filter((note) => note !== false)
          .join(" ")}
      </p>
    </div>
  );
}
