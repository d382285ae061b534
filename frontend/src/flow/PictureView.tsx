import type { Picture } from "../api/types";
import { ResultPicture } from "../result/ResultPicture";
import { CameraPicture } from "./CameraPicture";
import { ChoicesPicture } from "./ChoicesPicture";
import { DevicesPicture } from "./DevicesPicture";
import { ObjectPicture } from "./ObjectPicture";
import { StillPoses } from "./StillPoses";

/** The large picture of the step. */
export function PictureView({ picture }: { picture: Picture }) {
  switch (picture.kind) {
    case "devices":
      return <DevicesPicture devices={picture.devices} />;
    case "choices":
      return <ChoicesPicture choices={picture.choices} object={picture.object} />;
    case "object":
      return <ObjectPicture picture={picture} />;
    case "camera":
      return <CameraPicture target={picture.target} />;
    case "still":
      return <StillPoses picture={picture} />;
    case "result":
      return <ResultPicture picture={picture} />;
  }
}
