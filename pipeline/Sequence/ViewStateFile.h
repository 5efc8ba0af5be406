// Stores the state that lives on between frames as bytes, exact to the bit, so that a stopped run can go on from them.
#pragma once

#include "SceneViewState.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Little-endian; textures and buffers as they are stored. */
DRYDOCK_API std::string PackViewStates(const std::vector<FViewHistory>& Views);

/** Their textures come from the pool. File names the bytes in messages. Throws FError (exit code 3): not such bytes,
 * cut short, changed, or written under another r.Drydock.Storage. */
DRYDOCK_API std::vector<FViewHistory> UnpackViewStates(const std::string& Bytes, const std::string& File);

/** Equal for equal histories. Texels beside a texture's ViewRect do not count. */
DRYDOCK_API std::string FingerprintViewStates(const std::vector<FViewHistory>& Views);

} // namespace Drydock
