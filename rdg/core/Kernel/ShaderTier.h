// Defines what the graph asks of the shader tier (rdg/shader). The tier registers itself, so that neither includes the
// other, and a program can have the graph alone.
#pragma once

#include "DrydockAPI.h"
#include "ShaderCompileRequest.h"

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Drydock
{

/** A set of files on disk, by whatever path they are named. For one thread. */
class DRYDOCK_API FShaderFiles
{
public:
	explicit FShaderFiles(const std::vector<std::string>& Paths);
	/** Whether one of the set is among Files. */
	bool IsReadBy(const std::vector<std::string>& Files) const;

private:
	std::set<std::string> Canonical;
	mutable std::map<std::string, bool> Asked; // the answers so far, by path
};

/** The compiler of shaders. rdg/shader/Compiler/ShaderCompiler.h describes each function and its errors. */
class IShaderTier
{
public:
	virtual ~IShaderTier() = default;
	virtual std::shared_ptr<const FCompiledShader> Compile(const FShaderCompileRequest& Request) = 0;
	virtual FShaderReflection Reflect(const FShaderCompileRequest& Request) = 0;
	virtual std::string Fingerprint(const FShaderCompileRequest& Request) = 0;
	virtual void Forget() = 0;
	virtual void Forget(const FShaderFiles& Files) = 0;
};

/** Makes Tier the program's. The tier calls this before main; Tier must live as long as the program. */
DRYDOCK_API void RegisterShaderTier(IShaderTier& Tier);

/** The registered tier. Throws std::logic_error in a program that is linked without one. */
DRYDOCK_API IShaderTier& GetShaderTier();

} // namespace Drydock
