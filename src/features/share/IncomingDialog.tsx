import { useMemo } from "react";
import { cellOf } from "../../program/tools/tool-entry.ts";
import { pairTools } from "../../program/tools/tool-difference.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTools } from "../../app/document/tool-store.ts";
import { ModalDialog } from "../../app/base/ModalDialog.tsx";
import { leaveIncoming, takeIncoming, useIncoming, type Incoming } from "../../app/records/incoming.ts";
import { toolTableState } from "./tool-table-state.ts";
import { useTextsOrNull } from "../../app/base/settings/use-texts.ts";
import { WorkFacts } from "./WorkFacts.tsx";
import "./share.css";

/** The contents of a received link or file, before anything is opened. */
export function IncomingDialog() {
  const incoming = useIncoming((s) => s.incoming);
  return incoming && <Inside key={incoming.work.name} incoming={incoming} />;
}

function Inside({ incoming }: { readonly incoming: Incoming }) {
  const words = useTextsOrNull("handed");
  const mine = useTools((s) => s.list);
  const { control: device, machine } = useSettings();
  const { work, from } = incoming;
  const tools = useMemo(() => work.tools && pairTools(work.tools, mine), [work, mine]);
  if (!words) return null;
  const control = work.control ?? device;
  return (
    <ModalDialog title={words.inside(work.name)} done={leaveIncoming}>
      <p>{words.from[from]}</p>
      <WorkFacts
        words={words}
        work={work}
        machine={work.machine ?? machine}
        tools={
          tools ? (
            tools.length === 0 ? (
              words.none
            ) : (
              <ul className="handing-tools">
                {tools.map((tool) => (
                  <li key={tool.entry.id}>
                    {words.tool(cellOf(tool.entry, "T"), cellOf(tool.entry, "NAME"))}{" "}
                    <span className={`small ${toolTableState(tool) === "differs" ? "handing-differs" : "soft"}`}>
                      {words.state[toolTableState(tool)]}
                    </span>
                  </li>
                ))}
              </ul>
            )
          ) : (
            words.bare
          )
        }
        control={
          <>
            {control}{" "}
            <span className={`small ${control === device ? "soft" : "handing-differs"}`}>
              {control === device ? words.sameControl : words.otherControl(device)}
            </span>
          </>
        }
      />
      <p className="small soft">{words.opensSeparately}</p>
      <div className="modal-ways">
        <button type="button" className="button primary modal-first" onClick={() => takeIncoming(incoming)}>
          {words.open}
        </button>
        <button type="button" className="button" onClick={leaveIncoming}>
          {words.notNow}
        </button>
      </div>
    </ModalDialog>
  );
}
