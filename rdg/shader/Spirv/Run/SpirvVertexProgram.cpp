// A vertex shader as the command list runs it: by the interpreter, attributes in, clip position and TEXCOORDs out.
#include "Diagnostics.h"
#include "SpirvInterpreter.h"

#include <utility>

namespace Drydock
{

namespace
{

class FSpirvVertexProgram final : public FVertexProgram
{
public:
	FSpirvVertexProgram(FSpirvModule&& InModule, FSpirvReflection&& InReflection)
		: Module(std::move(InModule))
		, Reflection(std::move(InReflection))
	{
	}

	FVertexOutput Run(const FKernelArgs& Args, const FVertexInput& Input) const override
	{
		try
		{
			return FSpirvInterpreter(Module, Reflection).RunVertex(Args, Input);
		}
		catch (const FSpirvError& Error)
		{
			throw FError(
				{ESeverity::Error, 6020, Error.what(), Error.File, Error.Line, 0, "a vertex shader"}, ExitUsage);
		}
	}
	uint32_t GetAttributesRead() const override { return Reflection.AttributesRead; }
	uint32_t GetTexCoordsWritten() const override { return Reflection.TexCoordsWritten; }

private:
	FSpirvModule Module;
	FSpirvReflection Reflection;
};

} // namespace

std::shared_ptr<const FVertexProgram> MakeVertexProgram(FSpirvModule Module, FSpirvReflection Reflection)
{
	return std::make_shared<FSpirvVertexProgram>(std::move(Module), std::move(Reflection));
}

} // namespace Drydock
