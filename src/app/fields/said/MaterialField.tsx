import { useSettings } from "../../base/settings/settings.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { setMaterial } from "../../document/edits.ts";
import "./prompt-more.css";
import { useCuttingTable, useMaterialOfWork } from "./use-advice.ts";

/** The materials of the cutting data, as options. */
export function MaterialOptions() {
  const { materials } = useCuttingTable();
  return materials.map(({ id, name, group }) => <option key={id} value={id}>{`${group} · ${name}`}</option>);
}

/** The material of a work, by its id; empty for the default material of the device. */
export function MaterialSelect({
  id,
  choose,
  isNamed = true,
}: {
  readonly id: string;
  readonly choose: (id: string) => void;
  /** False under a heading that names it. */
  readonly isNamed?: boolean;
}) {
  const t = useTexts("advice");
  const { materials } = useCuttingTable();
  const device = useSettings((s) => s.material);
  const usual = materials.find((each) => each.id === device) ?? materials[0];
  return (
    <label className="material-field">
      <span className={isNamed ? undefined : "unseen"}>{t.material}</span>
      <select className="select" value={id} onChange={(event) => choose(event.currentTarget.value)}>
        <option value="">{t.ofDevice(usual ? `${usual.group} · ${usual.name}` : "")}</option>
        <MaterialOptions />
      </select>
    </label>
  );
}

/** The material of the open work. */
export function WorkMaterial({ isNamed = true }: { readonly isNamed?: boolean }) {
  const { own } = useMaterialOfWork();
  return <MaterialSelect id={own ?? ""} choose={setMaterial} isNamed={isNamed} />;
}

/** The material of the open work in its set-up, with the way to cutting data and advice. */
export function MaterialGroup() {
  const t = useTexts("advice");
  const { start } = useTexts("first");
  return (
    <fieldset className="setup-group">
      <legend>{t.material}</legend>
      <WorkMaterial isNamed={false} />
      <p className="guide-ways">
        <a href="#/guide/advice">{start.beyondAll.advice.what}</a>
      </p>
    </fieldset>
  );
}
