// Measures the memory that the views bound to a shader cover: the bytes that a dispatch is assumed to read and write.
#pragma once

#include "BoundShader.h"
#include "CoreTypes.h"

namespace Drydock
{

/** Bytes of all textures and buffers that it may read, each once and whole. */
uint64 GetBytesBoundForReading(const FBoundShader& Shader);

/** Bytes. A compute shader's writes are data; each thread is taken to write every view once, and no view more than
 * whole. */
uint64 GetBytesBoundForWriting(const FBoundShader& Shader, uint64 NumThreads);

/** A message where a dispatch has four times the groups that its textures take, or more; else empty. Threads that share
 * memory or count in buffers or integers may well be more than what they write. */
std::string FindTooManyGroups(const FBoundShader& Shader, const uint32 (&Counts)[3]);

} // namespace Drydock
