import { useRef, useState } from "react";
import type { ThreadRoles } from "../../../cycles/define.ts";
import { differencesFrom, threadOfValues, type FoundThread } from "../../../cycles/found-thread.ts";
import { valuesOfThread, type ThreadAim } from "../../../cycles/thread-values.ts";
import { designationOf, type Aim, type NamedThread } from "../../../kernel/thread/named-thread.ts";
import { threadsNamed } from "../../../kernel/thread/threads.ts";
import { noseRadius } from "../../../kernel/cutter/insert.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import type { SetupSizes } from "../../document/edits.ts";
import type { JobReading } from "../../document/reading.ts";
import { ComboboxInput, optionOf, useCombobox } from "../find/Combobox.tsx";
import { ThreadEnd } from "./ThreadEnd.tsx";
import { ThreadFacts, ThreadProposal } from "./ThreadProposal.tsx";
import { setupOfThread } from "./thread-blank.ts";
import { ThreadPicture } from "./ThreadPicture.tsx";
import { useThreadNumbers } from "./thread-numbers.ts";
import { useThreadOperation } from "./thread-operation.ts";
import "./thread-name.css";

/** Most names shown; another letter narrows the list. */
const SHOWN = 6;

interface Filled extends ThreadAim {
  readonly thread: NamedThread;
}

/** A thread by its name: suggestions while typing, the values it gives, and the name of the values that are there. */
export function ThreadName({
  read,
  roles,
  line,
  setAll,
  takeTool,
}: {
  readonly read: JobReading;
  readonly roles: ThreadRoles;
  readonly line: number | null;
  /** Writes typed texts, and for a job sizes of its set-up, in one step of undo. */
  readonly takeTool: ((T: number) => void) | undefined;
  readonly setAll: (texts: Readonly<Record<string, string>>, setup: SetupSizes) => void;
}) {
  const t = useTexts("threads");
  const numbers = useThreadNumbers(read);
  const box = useCombobox();
  const input = useRef<HTMLInputElement>(null);
  const [aim, setAim] = useState<Aim>("middle");
  const [byNose, setByNose] = useState(false);
  const [filled, setFilled] = useState<Filled | null>(null);
  const [said, say] = useState("");
  const operation = useThreadOperation(line);
  // The last calculated operation may have an older tool than the job.
  const tool = line === null ? read.tools.find(({ T }) => T === read.job.tool) : operation?.tool;
  const nose = tool?.TYPE === "THREAD" ? noseRadius(tool) : null;
  const found = threadsNamed(box.typed, SHOWN);
  const chosen = found[Math.min(box.chosen, found.length - 1)];
  const values = read.reading.partial;

  const put = (thread: NamedThread, how: ThreadAim) => {
    const fill = valuesOfThread(thread, roles, values, how);
    if (typeof fill === "string") return;
    const texts = Object.entries(fill.values).map(([q, value]) => [q, numbers.typed(q, value)]);
    setAll(Object.fromEntries(texts), line === null ? setupOfThread(read.job, fill) : {});
    setFilled({ thread, ...how });
    say(t.filled(numbers.name(designationOf(thread, fill.inside ? "inside" : "outside"))));
    box.change({ typed: "", chosen: 0 });
    // The proposal closes, and the focused button with it.
    input.current?.focus({ preventScroll: true });
  };
  const how: ThreadAim = { aim, nose: byNose ? nose : null };

  return (
    <section className="thread-name" aria-label={t.title}>
      <div className="thread-typed">
        <span className="small soft" aria-hidden="true">
          {t.title}
        </span>
        <ComboboxInput
          box={box}
          count={found.length}
          label={t.title}
          placeholder={t.example}
          className="input"
          input={input}
          take={(i) => {
            const thread = found[i];
            if (thread) put(thread, how);
          }}
        />
      </div>
      <ThreadPicture line={line} />
      <ul
        // A single thread is the proposal below.
        className={found.length < 2 ? "unseen" : "thread-options"}
        id={box.id}
        role="listbox"
        aria-label={t.found}
        hidden={found.length === 0}
      >
        {found.map((thread, i) => (
          <li
            key={`${thread.standard} ${thread.name}`}
            {...optionOf(box, i, found.length)}
            className="thread-option"
            onClick={() => box.change({ chosen: i })}
          >
            {numbers.name(thread.name)}
          </li>
        ))}
      </ul>
      {chosen && (
        <ThreadProposal
          thread={chosen}
          read={read}
          roles={roles}
          tool={tool ?? null}
          how={how}
          onAim={setAim}
          onNose={setByNose}
          isJob={line === null}
          takeTool={takeTool}
          onFill={() => put(chosen, how)}
        />
      )}
      <p className={found.length === 0 && box.typed !== "" ? "small soft" : "unseen"} role="status">
        {box.typed !== "" && found.length === 0 ? t.none : said}
      </p>
      {!chosen && <ThreadEnd line={line} />}
      {!chosen && (
        <FoundName
          read={read}
          roles={roles}
          tool={tool ?? null}
          nose={nose}
          filled={filled}
          takeTool={takeTool}
          onCorrect={put}
        />
      )}
    </section>
  );
}

/** The thread that the values are, or the one from which they differ. */
function FoundName({
  read,
  roles,
  tool,
  nose,
  filled,
  takeTool,
  onCorrect,
}: {
  readonly takeTool: ((T: number) => void) | undefined;
  readonly read: JobReading;
  readonly roles: ThreadRoles;
  readonly tool: Tool | null;
  readonly nose: number | null;
  readonly filled: Filled | null;
  readonly onCorrect: (thread: NamedThread, how: ThreadAim) => void;
}) {
  const t = useTexts("threads");
  const numbers = useThreadNumbers(read);
  const values = read.reading.partial;
  const ofFilled: FoundThread | null = filled && {
    ...filled,
    inside: values[roles.position] === 1,
    differences: differencesFrom(filled.thread, roles, values, filled),
  };
  const ofValues = ofFilled?.differences.length === 0 ? null : threadOfValues(roles, values, nose);
  const shown =
    ofFilled?.differences.length === 0 || ofValues?.differences.length !== 0 ? (ofFilled ?? ofValues) : ofValues;
  if (!shown) return null;
  const { thread, aim, inside, differences } = shown;
  const side = inside ? "inside" : "outside";
  const name = numbers.name(designationOf(thread, side));
  const tolerance = thread[side]?.tolerance;
  const place = aim === "middle" && tolerance ? t.middleOfClass : t.basic;
  return (
    <div className="thread-found">
      <p className="small">
        {differences.length === 0 ? (
          <>
            <strong>{t.is(name)}</strong> · {place}
          </>
        ) : (
          t.near(
            `${name} (${place})`,
            differences
              .map(({ q, is, should }) => t.difference(q, numbers.at(q, is), numbers.at(q, should)))
              .join("; "),
          )
        )}
      </p>
      {differences.length > 0 && (
        <button type="button" className="button small" onClick={() => onCorrect(thread, shown)}>
          {t.correct}
        </button>
      )}
      <ThreadFacts thread={thread} read={read} roles={roles} tool={tool} how={shown} takeTool={takeTool} short />
    </div>
  );
}
