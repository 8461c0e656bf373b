import { editSettings } from "../../app/document/edit-settings.ts";
import { setMaterial } from "../../app/document/edits.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useEditor } from "../../app/document/store.ts";
import { useCuttingTable, useMaterialOfWork } from "../../app/fields/said/use-advice.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

function Materials() {
  const { materials } = useCuttingTable();
  return materials.map(({ id, name, group }) => <option key={id} value={id}>{`${group} · ${name}`}</option>);
}

/** The material of the open work. */
export function WorkMaterial() {
  const t = useTexts("advice");
  const { own } = useMaterialOfWork();
  return (
    <label>
      <span>{t.material}</span>
      <select className="select" value={own ?? ""} onChange={(event) => setMaterial(event.currentTarget.value)}>
        <option value="">{t.ofDevice}</option>
        <Materials />
      </select>
    </label>
  );
}

/** The material of the open work, and the default material. */
export function MaterialChoice() {
  const t = useTexts("advice");
  const { materials } = useCuttingTable();
  const device = useSettings((s) => s.material);
  const isOpen = useEditor((s) => s.work !== null);
  return (
    <div className="advice-materials">
      {isOpen && <WorkMaterial />}
      <label>
        <span>{t.deviceMaterial}</span>
        <select
          className="select"
          value={materials.some(({ id }) => id === device) ? device : materials[0]?.id}
          onChange={(event) => void editSettings({ material: event.currentTarget.value })}
        >
          <Materials />
        </select>
      </label>
    </div>
  );
}
