/* All works of this device. */

export const fetchBringInDialog = () => import("./BringInDialog.tsx");
export const fetchElsewherePage = () => import("./ElsewherePage.tsx");
export const fetchThisDevice = () => import("./ThisDevice.tsx");
export const fetchWorksPage = () => import("./WorksPage.tsx");
export const fetchCrashHelp = () => import("./crash/CrashHelp.tsx");
export const fetchExportWorks = () => import("./export-works.ts");
