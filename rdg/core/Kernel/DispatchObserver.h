// Declares an observer of shaders while passes run: it sees each shader's arguments and results.
#pragma once

#include "BoundShader.h"
#include "Templates/UnrealTemplate.h"

namespace Drydock
{

/** Calls come from the thread that executes the graph, around all tiles of one draw or dispatch. Textures and buffers
 * may be read during a call; an observer that wants to run the shader itself does so on copies of what it writes. */
class DRYDOCK_API IDispatchObserver
{
public:
	virtual ~IDispatchObserver();
	/** Whether draws and dispatches may get their results from a cache (DispatchReuse.h) in its scope. It is called
	 * about these, too; what it writes itself it has to tell (FRHITexture::Touch). */
	virtual bool AllowsReuse() const { return false; }
	virtual void BeforeDispatch(const FBoundShader&, const FKernelArgs&, const FKernelTile& /*Whole*/) {}
	virtual void AfterDispatch(const FBoundShader&, const FKernelArgs&, const FKernelTile& /*Whole*/) {}
};

/** Those in scope, the outermost first: it sees each dispatch before the others, and is the last to see what became of
 * it. */
DRYDOCK_API const std::vector<IDispatchObserver*>& GetDispatchObservers();

/** During its scope the observer sees every dispatch of the process. */
class DRYDOCK_API FScopedDispatchObserver : private FNoncopyable
{
public:
	explicit FScopedDispatchObserver(IDispatchObserver& Observer);
	~FScopedDispatchObserver();
};

} // namespace Drydock
