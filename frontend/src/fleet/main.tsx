import { startSession } from "../api/session";
import { mountPage } from "../mountPage";
import { FleetPage } from "./FleetPage";

// it reads the address, before the provider's answer is removed from it
const mounted = mountPage(<FleetPage />);
void startSession();
await mounted;
