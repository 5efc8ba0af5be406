// Ends the program when a shader's loop does not end, with a message that names the shader. A GPU's driver removes the
// device after two seconds; a CPU would hang for good.
#pragma once

#include "CoreMinimal.h"
#include "HAL/Watchdog.h"

#include <optional>
#include <string>

namespace Drydock
{

/** Watches a kernel that runs over tiles, during its scope. Once no tile has ended for r.Drydock.ShaderSeconds (0:
 * never), one message DD6040 goes to stderr and the process ends with exit code 2: running kernels cannot be stopped in
 * any other way. */
class DRYDOCK_API FKernelWatch : private FNoncopyable
{
public:
	/** The names must outlive it. */
	FKernelWatch(const std::string& Shader, const std::string& EntryPoint);
	~FKernelWatch();

	/** From any thread. */
	void TileHasEnded()
	{
		if (Watch)
		{
			Watch->IsAlive();
		}
	}

private:
	std::optional<FWatchdog> Watch; // none: no limit
};

} // namespace Drydock
