import { editSettings } from "../../app/document/edit-settings.ts";
import { MaterialOptions, WorkMaterial } from "../../app/fields/said/MaterialField.tsx";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useEditor } from "../../app/document/store.ts";
import { useCuttingTable } from "../../app/fields/said/use-advice.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";

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
          <MaterialOptions />
        </select>
      </label>
    </div>
  );
}
