// Declares a backend that runs shaders in place of their kernels: another device, which gets a kernel's arguments.
#pragma once

#include "BoundShader.h"

#include <string>

namespace Drydock
{

/** Calls come from the thread that executes the graph, one for a draw or dispatch. */
class DRYDOCK_API IDispatchBackend
{
public:
	virtual ~IDispatchBackend();

	/** Runs all threads of Whole, and returns when what they wrote is in the arguments' textures, buffers and targets.
	 * Not empty: why it cannot; then nothing was written, and the kernel runs. */
	virtual std::string Run(const FBoundShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole) = 0;

	/** Name of the device that shaders run on, for people to read. */
	virtual std::string GetDeviceName() const = 0;
};

/** Null: kernels run. */
DRYDOCK_API IDispatchBackend* GetDispatchBackend();

/** Asked at each draw and dispatch; may throw FError. */
using FDispatchBackendChooser = IDispatchBackend* (*)();
DRYDOCK_API void SetDispatchBackendChooser(FDispatchBackendChooser Chooser);

} // namespace Drydock
