import { useRef, useState } from "react";
import { formatNumber } from "../../i18n/number.ts";
import {
  ISO_GROUPS,
  readCuttingTable,
  usualTable,
  writeCuttingTable,
  type CutMaterial,
  type CuttingTable,
} from "../../program/tools/cutting-table.ts";
import { downloadText } from "../../app/base/download.ts";
import { Icon } from "../../app/base/Icon.tsx";
import { NumberInput } from "../../app/fields/number/NumberInput.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { editSettings } from "../../app/document/edit-settings.ts";
import { useCuttingTable } from "../../app/fields/said/use-advice.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

const NUMBERS = ["roughSpeed", "roughFeed", "finishSpeed", "finishFeed", "kc11", "mc"] as const;

interface CellProps {
  readonly name: string;
  readonly value: string;
  readonly isText?: boolean;
  /** False if the text is invalid there. */
  readonly take: (text: string) => boolean;
}

/** A cell keeps its typed text until it is left; an invalid text is discarded. */
function Cell({ name, value, take, isText = false }: CellProps) {
  const [typed, type] = useState<string | null>(null);
  const [refused, refuse] = useState(false);
  return (
    <NumberInput
      kind={isText ? "text" : "typed"}
      inputMode={isText ? "text" : "decimal"}
      aria-label={name}
      text={typed ?? value}
      aria-invalid={refused}
      onText={type}
      onLeave={() => {
        if (typed === null) return;
        refuse(typed !== value && !take(typed));
        type(null);
      }}
    />
  );
}

/** The shop's own cutting data: edited cell by cell, imported from a file, restored. */
export function CuttingDataTable() {
  const { table: t, values, groups } = useTexts("advice");
  const language = useSettings((s) => s.language);
  const table = useCuttingTable();
  const own = useSettings((s) => s.cutting !== "");
  const [said, say] = useState<string | null>(null);
  const file = useRef<HTMLInputElement>(null);
  const change = (next: CuttingTable): boolean => {
    const text = writeCuttingTable(next);
    const fits = readCuttingTable(text) !== null;
    say(fits ? null : t.refused);
    if (fits) void editSettings({ cutting: text });
    return fits;
  };
  const put = (id: string, part: Partial<CutMaterial>) =>
    change({ ...table, materials: table.materials.map((each) => (each.id === id ? { ...each, ...part } : each)) });
  const number = (text: string) => Number(text.trim().replace(",", "."));
  const add = () => {
    const numbers = table.materials.map(({ id }) => Number(/^own(\d+)$/.exec(id)?.[1] ?? 0));
    const [first] = usualTable.materials;
    if (first)
      change({
        ...table,
        materials: [...table.materials, { ...first, id: `own${Math.max(0, ...numbers) + 1}`, name: t.newName }],
      });
  };
  const take = async (chosen: File) => {
    const read = readCuttingTable(await chosen.text());
    say(read && change(read) ? t.taken : t.wrong);
  };
  return (
    <section className="advice-table" aria-label={t.title}>
      <h2>{t.title}</h2>
      <p className="soft">{t.lead}</p>
      <label className="advice-power">
        <span>{t.power}</span>
        <Cell
          name={t.power}
          value={formatNumber(language, table.power)}
          take={(text) => change({ ...table, power: number(text) })}
        />
      </label>
      <div className="advice-scroll">
        <table>
          <thead>
            <tr>
              <th scope="col">{t.name}</th>
              <th scope="col">{t.group}</th>
              {NUMBERS.map((key) => (
                <th key={key} scope="col">
                  {values[key]}
                </th>
              ))}
              <td />
            </tr>
          </thead>
          <tbody>
            {table.materials.map((each) => (
              <tr key={each.id}>
                <td className="advice-name">
                  <Cell
                    isText
                    name={t.cell(t.name, each.name)}
                    value={each.name}
                    take={(text) => put(each.id, { name: text.trim() })}
                  />
                </td>
                <td>
                  <select
                    className="select"
                    aria-label={t.cell(t.group, each.name)}
                    value={each.group}
                    onChange={(event) => {
                      const group = ISO_GROUPS.find((one) => one === event.currentTarget.value);
                      if (group) put(each.id, { group });
                    }}
                  >
                    {ISO_GROUPS.map((group) => (
                      <option key={group} value={group}>{`${group} · ${groups[group]}`}</option>
                    ))}
                  </select>
                </td>
                {NUMBERS.map((key) => (
                  <td key={key}>
                    <Cell
                      name={t.cell(values[key], each.name)}
                      value={formatNumber(language, each[key])}
                      take={(text) => put(each.id, { [key]: number(text) })}
                    />
                  </td>
                ))}
                <td>
                  <button
                    type="button"
                    className="button icon plain"
                    aria-label={t.remove(each.name)}
                    disabled={table.materials.length === 1}
                    onClick={() => change({ ...table, materials: table.materials.filter(({ id }) => id !== each.id) })}
                  >
                    <Icon name="remove" />
                  </button>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <div className="guide-turns">
        <button type="button" className="button" onClick={add}>
          <Icon name="add" /> {t.add}
        </button>
        <button type="button" className="button" onClick={() => downloadText(writeCuttingTable(table), "CUTTING.json")}>
          <Icon name="download" /> {t.save}
        </button>
        <button type="button" className="button" onClick={() => file.current?.click()}>
          {t.open}
        </button>
        <button type="button" className="button" disabled={!own} onClick={() => void editSettings({ cutting: "" })}>
          {t.reset}
        </button>
        <input
          ref={file}
          type="file"
          hidden
          accept=".json,application/json"
          onChange={(event) => {
            const [chosen] = event.currentTarget.files ?? [];
            event.currentTarget.value = "";
            if (chosen) void take(chosen);
          }}
        />
      </div>
      <p role="status">{said}</p>
    </section>
  );
}
