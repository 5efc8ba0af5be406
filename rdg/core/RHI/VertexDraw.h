// Holds the vertex state of a command list: the pipeline state's vertex shader and layout, the buffers that feed it;
// and one draw of them.
#pragma once

#include "BoundShader.h"
#include "Diagnostics.h"
#include "RHIBuffer.h"
#include "RHIStates.h"
#include "VertexProgram.h"

#include <string>
#include <vector>

namespace Drydock
{

/** HLSL name of the uniform buffer that Common.ush's DrawRectangle reads and that DrawRectangle in C++ fills. */
inline constexpr const char* GDrawRectangleParametersName = "DrawRectangleParameters";

enum EVertexError : int
{
	WarnNoRectangle = 2130,    // triangles in perspective and the like: they are not drawn
	ErrorVertexInput = 2131,   // a vertex shader reads what the draw does not give it
	ErrorVertexToPixel = 2132, // a pixel shader reads a semantic that the vertex shader does not write
	ErrorTargetKind = 2133,    // a pixel shader writes integers to a target of reals, or reals to one of integers
};

/** Vertices of a draw of one instance. */
struct FVertexDraw
{
	FRHIBuffer* IndexBuffer = nullptr; // null: vertices in a row
	bool bIndexed = false;
	int32 BaseVertex = 0;
	uint32 FirstIndex = 0;
	uint32 FirstInstance = 0;
	uint32 NumPrimitives = 0;
};

struct DRYDOCK_API FVertexState
{
	static constexpr int32 MaxStreams = 16;

	struct FStream
	{
		TRefCountPtr<FRHIBuffer> Buffer;
		uint32 Offset = 0;
	};

	/** Forgets the parameters, keeps the streams. */
	void SetPipeline(const FGraphicsPipelineStateInitializer& Initializer);

	/** Three vertices for each triangle of an instance, of a draw that was checked. Their interpolants are in the
	 * places where Pixel reads them. */
	std::vector<FVertexOutput> RunVertices(
		const FVertexDraw& Draw, uint32 Instance, const FShaderReflection& Pixel) const;

	/** Throws FError (DD2131) unless there is an index buffer where one is meant, a rectangle of the screen where the
	 * shader reads one, and an element and a buffer for every attribute that it reads. */
	void CheckInput(const FVertexDraw& Draw) const;

	/** Throws FError (DD2132) where a pixel shader reads a semantic that the vertex shader, or the engine's where
	 * none is bound, does not write, or integers where floats are written. */
	void CheckTexCoords(const FBoundShader& Pixel) const;

	TRefCountPtr<FRHIVertexShader> Shader;
	TRefCountPtr<FRHIVertexDeclaration> Declaration;
	EPrimitiveType PrimitiveType = PT_TriangleList;
	FBoundShader Bound;
	FStream Streams[MaxStreams];
	bool bDrawsScreenRectangle = false; // the uniform buffer DrawRectangleParameters is set

private:
	/** The output of the vertex shader that has the semantic of an interpolant of Pixel; -1: none has. */
	int32 FindOutput(const FShaderReflection& Pixel, int32 Interpolant) const;
	void CheckAttribute(uint32 Attribute) const;
	std::vector<uint32> GetVertexIds(const FVertexDraw& Draw) const;
	FVertexInput Fetch(const FVertexDraw& Draw, uint32 VertexId, uint32 Instance) const;
};

/** Makes what draws and dispatches run of a shader whose parameters nobody has set. Throws FError (DD2131) where it
 * reads parameters. Set once, by the code that binds shaders. */
using FShaderBinder = FBoundShader (*)(FShader& Shader);
DRYDOCK_API void SetShaderBinder(FShaderBinder Binder);
/** Binds the shader of the pipeline state, if nothing is bound. */
DRYDOCK_API void BindIfNothingIs(FBoundShader& Bound, const FRHIShader* Shader);
/** Throws FError (DD2131) where parameters are set one by one and one that is read is not. */
DRYDOCK_API void RequireAllSet(const FBoundShader& Bound);

/** A message of a draw, with the words of the pass that runs. */
DRYDOCK_API FDiagnostic MakeVertexDiagnostic(ESeverity Severity, EVertexError Code, const std::string& Message);

} // namespace Drydock
