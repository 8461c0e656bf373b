import type { OfflineTexts } from "../en/offline.ts";
import { typeset } from "./typography/typeset.ts";

export const offline: OfflineTexts = typeset({
  ready: "Une version plus récente de Turnwise est prête.",
  updateNow: "Mettre à jour",
  later: "Plus tard",
  elsewhere: "Turnwise a été mis à jour dans un autre onglet. Celui-ci continue avec sa version.",
  reload: "Recharger la page",
  look: "Chercher une version plus récente",
  kept: {
    impossible: "Ce navigateur ne garde pas la page pour l’usage sans réseau ; il faut une adresse en https.",
    coming: "La page est enregistrée sur cet appareil, pour l’usage sans réseau.",
    kept: "Enregistrée sur cet appareil : fonctionne sans réseau.",
    failed: "La page n’est pas encore entière sur cet appareil. La suite viendra dès qu’il y aura un réseau.",
  },
  looked: {
    no: "",
    looking: "Recherche d’une version plus récente.",
    coming: "Une version plus récente est en cours de chargement.",
    newest: "C’est la version la plus récente.",
    unreachable: "Le serveur ne répond pas. Ce qui est ici continue de fonctionner.",
    unfinished: "La nouvelle version n’est pas arrivée entière. Celle-ci reste en service.",
  },
});
