/* The finished part as STL or DXF. */

export const fetchPartExport = () => import("./PartExport.tsx");
