import { useMemo, useState } from "react";
import type { HandedTexts } from "../../i18n/en/handed.ts";
import { cellOf, readEntry, type ToolEntry } from "../../program/tools/tool-entry.ts";
import { pairTools, type KeepAs, type KeptTools, type ToolPair } from "../../program/tools/tool-difference.ts";
import { InsertDrawing } from "../../app/pictures/lathe/InsertDrawing.tsx";
import { Icon } from "../../app/base/Icon.tsx";
import { Message } from "../../app/base/Message.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { bundleOf, useEditor } from "../../app/document/store.ts";
import { useTools } from "../../app/document/tool-store.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { toolTableState } from "./tool-table-state.ts";
import { nameOfMachine } from "./machine-name.ts";
import {
  renumberCalls,
  countAffectedCalls,
  keepWorkTools,
  switchToDeviceControl,
  switchToDeviceMachine,
  switchToDeviceTable,
} from "./work-tools-edits.ts";
import "./share.css";

/** Edge length of an insert drawing, px. */
const DRAWING = 40;
const WAYS = ["mine", "theirs", "free"] as const satisfies readonly KeepAs[];

interface Props {
  readonly words: HandedTexts;
  readonly done: () => void;
}

/** The tools that came with the open work, compared with those of this device, and the actions on them. */
export function WorkTools({ words, done }: Props) {
  const tools = useEditor((s) => bundleOf(s).tools);
  const control = useEditor((s) => bundleOf(s).control);
  const mine = useTools((s) => s.list);
  const device = useSettings((s) => s.control);
  const machine = useEditor((s) => bundleOf(s).machine);
  const own = useSettings((s) => s.machine);
  const beside = useMemo(() => pairTools(tools ?? [], mine), [tools, mine]);
  const [chosen, choose] = useState<Readonly<Record<string, KeepAs>>>({});
  const [kept, setKept] = useState<KeptTools | null>(null);
  const wayOf = ({ entry }: ToolPair): KeepAs => chosen[entry.id] ?? "mine";
  const isAllMine = beside.every(({ mine: own, differs }) => own !== null && differs.length === 0);

  return (
    <ModalDialog title={words.ofWork} done={done}>
      {tools && (
        <>
          <p>{words.ofWorkLead}</p>
          <ul className="work-tools" aria-label={words.ofWork}>
            {beside.map((tool) => (
              <WorkTool
                key={tool.entry.id}
                words={words}
                beside={tool}
                way={wayOf(tool)}
                onWay={(way) => choose((now) => ({ ...now, [tool.entry.id]: way }))}
              />
            ))}
          </ul>
        </>
      )}
      <div role="status">
        {kept && <KeepResult words={words} kept={kept} />}
        {!kept && tools && isAllMine && <p className="small">{words.allMine}</p>}
      </div>
      {tools && (
        <div className="modal-ways">
          {!isAllMine && (
            <button type="button" className="button" onClick={() => setKept(keepWorkTools(wayOf))}>
              <Icon name="add" /> {words.keep}
            </button>
          )}
          <button
            type="button"
            className="button"
            onClick={() => {
              switchToDeviceTable();
              done();
            }}
          >
            {words.useMine}
          </button>
        </div>
      )}
      {control !== undefined && control !== device && (
        <div className="work-control">
          <p>{words.control(control, device)}</p>
          <button type="button" className="button" onClick={switchToDeviceControl}>
            {words.useControl(device)}
          </button>
        </div>
      )}
      {machine !== undefined && machine !== own && (
        <div className="work-control">
          <p>{words.machine(nameOfMachine(words, machine), nameOfMachine(words, own))}</p>
          <button type="button" className="button" onClick={switchToDeviceMachine}>
            {words.useMachine}
          </button>
        </div>
      )}
    </ModalDialog>
  );
}

/** Name of a tool in these lists. */
const nameOf = (words: HandedTexts, entry: ToolEntry): string => words.tool(cellOf(entry, "T"), cellOf(entry, "NAME"));

/** One tool that came with the work; if it differs from the device's tool of its number, both side by side. */
function WorkTool({
  words,
  beside,
  way,
  onWay,
}: {
  readonly words: HandedTexts;
  readonly beside: ToolPair;
  readonly way: KeepAs;
  readonly onWay: (way: KeepAs) => void;
}) {
  const { entry, mine, differs } = beside;
  const drawn = readEntry(entry).tool;
  const other = mine && differs.length > 0 ? mine : null;
  const otherDrawn = other && readEntry(other).tool;
  const name = nameOf(words, entry);
  return (
    <li className="work-tool">
      <p className="work-tool-name">
        {drawn && <InsertDrawing tool={drawn} width={DRAWING} height={DRAWING} />}
        <b>{name}</b>{" "}
        <span className={`small ${other ? "handing-differs" : "soft"}`}>{words.state[toolTableState(beside)]}</span>
      </p>
      {other && (
        <>
          <table className="work-tool-differs">
            <thead>
              <tr>
                <th scope="col">{words.column}</th>
                <th scope="col">{words.theirs}</th>
                <th scope="col">
                  {words.mine} {otherDrawn && <InsertDrawing tool={otherDrawn} width={DRAWING} height={DRAWING} />}
                </th>
              </tr>
            </thead>
            <tbody>
              {differs.map((cell) => (
                <tr key={cell}>
                  <th scope="row">{cell}</th>
                  <td className="number">{cellOf(entry, cell) || "–"}</td>
                  <td className="number">{cellOf(other, cell) || "–"}</td>
                </tr>
              ))}
            </tbody>
          </table>
          <select
            className="select"
            aria-label={words.becomes(name)}
            value={way}
            onChange={(event) => onWay(WAYS.find((each) => each === event.target.value) ?? "mine")}
          >
            {WAYS.map((each) => (
              <option key={each} value={each}>
                {words.as[each]}
              </option>
            ))}
          </select>
        </>
      )}
    </li>
  );
}

/** Result of keeping the tools, and the change of calls for renumbered ones. */
function KeepResult({ words, kept }: { readonly words: HandedTexts; readonly kept: KeptTools }) {
  const { added, replaced, moved } = kept;
  const [called, call] = useState(false);
  const [calls] = useState(() => countAffectedCalls(moved));
  return (
    <Message as="div" tone="info">
      <div>
        <p>{added + replaced > 0 ? words.kept(added, replaced) : words.nothingToKeep}</p>
        {moved.map(({ from, to }) => (
          <p key={from}>{words.moved(from, to)}</p>
        ))}
        {called && <p>{words.callsChanged}</p>}
        <div className="modal-ways">
          {moved.length > 0 && calls > 0 && !called && (
            <button
              type="button"
              className="button"
              onClick={() => {
                renumberCalls(moved);
                call(true);
              }}
            >
              {words.changeCalls(calls)}
            </button>
          )}
        </div>
      </div>
    </Message>
  );
}
