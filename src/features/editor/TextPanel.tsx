import { Suspense, useEffect, useMemo, useRef, useState } from "react";
import { lazyWithin } from "../../app/base/parts.ts";
import { Message } from "../../app/base/Message.tsx";
import { CopyButton } from "../../app/fields/program/CopyButton.tsx";
import { copyProgram } from "../../app/fields/leaving/copy-program.ts";
import { CopyStatus } from "../../app/fields/leaving/CopyStatus.tsx";
import { hasListWithoutTilde } from "../../nc/program.ts";
import { withListTildes } from "../../nc/list-tildes.ts";
import { FileNote } from "../../app/fields/program/FileNote.tsx";
import { useFileKind } from "../../app/document/output.ts";
import { isoFile } from "../../app/document/printed.ts";
import { confirmExport } from "../../app/fields/leaving/confirm-export.ts";
import { ProgramMenus } from "../../app/fields/program/ProgramMenus.tsx";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { useEditor } from "../../app/document/store.ts";
import { encode, notIn } from "../../app/document/encoding.ts";
import { downloadBytes } from "../../app/base/download.ts";
import { editProgram, sessionDom, sessionText, sessionView, useSession } from "../../app/fields/blocks/session.ts";
import { shownFile, useShownName } from "../../app/document/shown-file.ts";
import { showTextBlock } from "../../app/fields/blocks/show-text-block.ts";
import { TEXT_AREA, type TextBar } from "../../app/fields/find/text-bar.ts";
import { SaveButton } from "./SaveButton.tsx";
import { SkipSwitch } from "./SkipSwitch.tsx";
import { WorkFiles } from "./WorkFiles.tsx";
import "../../app/fields/find/find.css";

const TextTools = lazyWithin(async () => ({ default: (await import("./TextTools.tsx")).TextTools }));

interface Props {
  /** The bar above the text: find, replace, go to. */
  readonly bar: TextBar;
  readonly toBlock?: () => void;
}

/** The text of the program, with the actions on its file. */
export function TextPanel({ bar, toBlock }: Props) {
  const t = useTexts();
  const box = useRef<HTMLDivElement>(null);
  const name = useShownName();
  const ready = useSession((s) => s.reading);
  const kind = useFileKind();
  const isUntiedText = useMemo(() => ready.program.blocks.some(hasListWithoutTilde), [ready]);
  const leavesOut = useEditor((s) => s.program?.skipMarked ?? false);
  const [saved, setSaved] = useState<string | null>(null);
  const foreign = useEditor((s) => (s.program ? notIn(shownFile(s.program)) : null));

  useEffect(() => {
    const dom = sessionDom();
    if (!dom || dom.parentElement === box.current) return;
    box.current?.append(dom);
    sessionView()?.requestMeasure();
  }, [ready]);

  const bytes = () => {
    const { program } = useEditor.getState();
    return encode(sessionText() ?? "", program ? shownFile(program).encoding : "utf-8");
  };
  const download = () => downloadBytes(bytes(), name);
  const downloadIso = async () => {
    const { text } = await isoFile(sessionText() ?? "");
    if (await confirmExport("download")) downloadBytes(encode(text, "utf-8"), `${name.replace(/\.[^.]*$/, "")}.i`);
  };

  return (
    <section className={`program text-panel${leavesOut ? " leaves-out" : ""}`} aria-label={t.page.text.title}>
      <WorkFiles />
      <SkipSwitch />
      <div className="text-area" {...{ [TEXT_AREA]: "" }}>
        <Suspense fallback={<div className="text-tools" />}>
          <TextTools bar={bar} />
        </Suspense>
        <div ref={box} className="text-editor number" />
      </div>
      {foreign !== null && (
        <Message role="status" tone="warning">
          {t.editor.otherEncoding(foreign, name)}
        </Message>
      )}
      <FileNote
        {...(isUntiedText
          ? {
              text: t.page.text.untied,
              warns: true,
              cure: { name: t.page.text.tie, go: () => editProgram(withListTildes(ready.program), null) },
            }
          : { text: t.page.text.files[kind] })}
      />
      <div className="program-foot">
        {toBlock && (
          <button type="button" className="button to-block" onClick={toBlock}>
            {t.editor.form}
          </button>
        )}
        <div className="program-buttons">
          <CopyButton copy={() => void copyProgram(sessionText() ?? "")} />
          <SaveButton
            name={name}
            mayLeave={async () => (await confirmExport("save")) !== null}
            onSaved={setSaved}
            onDownload={download}
            showBlock={showTextBlock}
          />
          <ProgramMenus
            showBlock={showTextBlock}
            files={[
              {
                name: t.page.text.download(name),
                icon: "download",
                hint: t.page.text.files[kind],
                go: () => void confirmExport("download").then((verdict) => verdict && download()),
              },
              { name: t.page.text.asIso, icon: "download", go: () => void downloadIso() },
            ]}
          />
        </div>
      </div>
      <CopyStatus otherwise={saved === null ? "" : t.editor.saved(saved)} />
    </section>
  );
}
